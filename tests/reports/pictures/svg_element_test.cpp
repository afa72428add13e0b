#include "reports/pictures/svg_element.hpp"

#include <gtest/gtest.h>

#include "reports/pictures/axis.hpp"

namespace kempe {
namespace {

TEST(SvgElement, WritesAttributesInTheirOrderAndClosesItself) {
  EXPECT_EQ(SvgElement("circle").with("class", "pin").at("cx", "cy", {1.5, -2}).with("r", 0.12345).text(),
            "<circle class=\"pin\" cx=\"1.5\" cy=\"-2\" r=\"0.123\"/>");
}

TEST(SvgElement, WhatComesFromOutsideCannotLeaveItsPlace) {
  EXPECT_EQ(SvgElement("text").with("class", "\"><script>").saying("</text> & more").line(),
            "<text class=\"&quot;&gt;&lt;script&gt;\">&lt;/text&gt; &amp; more</text>\n");
}

TEST(SvgElement, HoldsElementsAsTheyAre) {
  EXPECT_EQ(SvgElement("g").holding(SvgElement("path").with("d", "M0,0").text()).text(),
            "<g><path d=\"M0,0\"/></g>");
}

TEST(Axis, EndsStandAtEndsAndTicksOnWholeSteps) {
  const Axis axis = axis_over(-3, 7, 8, 100, 0);
  EXPECT_EQ(axis.at(-3), 100);
  EXPECT_EQ(axis.at(7), 0);
  EXPECT_EQ(axis.at(2), 50);
  EXPECT_EQ(axis.ticks(), std::vector<double>({-2, 0, 2, 4, 6}));
}

}  // namespace
}  // namespace kempe

// No modules are loaded in a page: what asks for one (the STEP assembly) is told that it is not there, instead of ending the engine.
mergeInto(LibraryManager.library, {
  _dlopen_js: function () { return 0; },
  _dlsym_js: function () { return 0; },
});

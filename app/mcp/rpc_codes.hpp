#pragma once
// The error codes of JSON-RPC 2.0.

namespace kempe::app {

struct RpcCode {
  static constexpr int parse_error = -32700;
  static constexpr int invalid_request = -32600;
  static constexpr int method_not_found = -32601;
  static constexpr int invalid_params = -32602;
  static constexpr int internal_error = -32603;
};

}  // namespace kempe::app

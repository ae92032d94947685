package vericommand;

/** The result of reading one key, or of a time without keys. */
public sealed interface Recognition {
    /** The order is incomplete, or none is open. */
    record Pending() implements Recognition {}

    /** The key closed an order. */
    record Complete(Order order) implements Recognition {}

    /** A key does not fit; reported once per broken order. */
    record Broken(OrderFault fault) implements Recognition {}

    Recognition PENDING = new Pending();
}

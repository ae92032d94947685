package vericommand;

/** What one key (or a time without one) has led to. */
public sealed interface Recognition {
    /** Nothing to tell yet. */
    record Pending() implements Recognition {}

    /** The key closed an order. */
    record Complete(Order order) implements Recognition {}

    /** The order is broken; told exactly once per broken order. */
    record Broken(OrderFault fault) implements Recognition {}

    Recognition PENDING = new Pending();
}

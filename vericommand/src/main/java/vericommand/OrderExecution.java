package vericommand;

/** An order that moves, on its way through its instructions. */
final class OrderExecution {
    private final Order order;
    private final OrderOrigin source;
    private int done;
    private boolean announced;
    private boolean stopOrdered;

    OrderExecution(Order order, OrderOrigin source) {
        this.order = order;
        this.source = source;
    }

    Order order() {
        return order;
    }

    OrderOrigin source() {
        return source;
    }

    int done() {
        return done;
    }

    boolean isComplete() {
        return done == order.instructions().size();
    }

    Instruction present() {
        return order.instructions().get(done);
    }

    void presentIsDone() {
        done++;
    }

    /** True the first time only: the order has begun to move. */
    boolean announce() {
        boolean first = !announced;
        announced = true;
        return first;
    }

    void orderStop() {
        stopOrdered = true;
    }

    boolean isStopOrdered() {
        return stopOrdered;
    }

    /** Whether no further instruction may begin. */
    boolean endsHere() {
        return stopOrdered || source.isGone();
    }

    OrderProgress progress(double amountDone) {
        return new OrderProgress(
                (Instruction.Motion) present(),
                amountDone,
                done + 1,
                order.instructions().size());
    }
}

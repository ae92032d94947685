package vericommand;

/** An order that moves, on its way through its instructions. */
final class Execution {
    private final Order order;
    private final Source source;
    private int done;
    private boolean announced;
    private boolean stopOrdered;

    Execution(Order order, Source source) {
        this.order = order;
        this.source = source;
    }

    Order order() {
        return order;
    }

    Source source() {
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

    Progress progress(double amountDone) {
        return new Progress(
                (Instruction.Motion) present(),
                amountDone,
                done + 1,
                order.instructions().size());
    }
}

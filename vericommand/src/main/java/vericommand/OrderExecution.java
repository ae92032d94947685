package vericommand;

/** A complete order and how many of its instructions are done. */
final class OrderExecution {
    private final Order order;
    private final OrderOrigin origin;
    private int done;
    private boolean announced;
    private boolean stopOrdered;

    OrderExecution(Order order, OrderOrigin origin) {
        this.order = order;
        this.origin = origin;
    }

    Order order() {
        return order;
    }

    OrderOrigin origin() {
        return origin;
    }

    int done() {
        return done;
    }

    boolean isComplete() {
        return done == order.instructions().size();
    }

    Instruction current() {
        return order.instructions().get(done);
    }

    void advance() {
        done++;
    }

    /** True for the first call only: the order's first motion starts. */
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

    /** True if no further instruction may start. */
    boolean isCancelled() {
        return stopOrdered || origin.isEnded();
    }

    OrderProgress progress(double amountDone) {
        return progress(done, amountDone);
    }

    /** The progress of an order whose first motion has not started. */
    OrderProgress initialProgress() {
        int index = 0;
        while (!Order.moves(order.instructions().get(index))) {
            index++;
        }
        return progress(index, 0);
    }

    private OrderProgress progress(int index, double amountDone) {
        var instructions = order.instructions();
        return new OrderProgress(instructions.get(index), amountDone, index + 1, instructions.size());
    }
}

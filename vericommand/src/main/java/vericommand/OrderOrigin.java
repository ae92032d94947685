package vericommand;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** The source of an order, which gets its reply: one call, one short message or one order of a program. */
final class OrderOrigin {
    private final OrderSource source;
    private final String from;
    private final Consumer<OrderReport> follower;
    private final Supplier<Pose> pose;
    private Optional<String> verdict = Optional.empty();
    private Optional<Reply> reply = Optional.empty();
    private boolean ended;

    private OrderOrigin(OrderSource source, String from, Supplier<Pose> pose, Consumer<OrderReport> follower) {
        this.source = source;
        this.from = from;
        this.pose = pose;
        this.follower = follower;
    }

    static OrderOrigin call(String number) {
        return new OrderOrigin(OrderSource.CALL, number, () -> null, report -> {});
    }

    static OrderOrigin message(String number) {
        return new OrderOrigin(OrderSource.MESSAGE, number, () -> null, report -> {});
    }

    /** @param follower receives each change, the first when the order waits */
    static OrderOrigin program(String operator, Supplier<Pose> pose, Consumer<OrderReport> follower) {
        OrderOrigin origin = new OrderOrigin(OrderSource.PROGRAM, operator, pose, follower);
        origin.report(OrderReport.State.WAITING);
        return origin;
    }

    /** The number, or the name of a program's operator. */
    String from() {
        return from;
    }

    OrderSource source() {
        return source;
    }

    void verified(String word) {
        verdict = Optional.of(word);
        report(OrderReport.State.WAITING);
    }

    void moves() {
        report(OrderReport.State.MOVING);
    }

    /** @param isLast false for the reply to the start of a process */
    void answered(Reply newest, boolean isLast) {
        reply = Optional.of(newest);
        report(isLast ? OrderReport.State.ENDED : OrderReport.State.MOVING);
    }

    /** Another order has ended the process, without a reply. */
    void replaced() {
        report(OrderReport.State.ENDED);
    }

    private void report(OrderReport.State state) {
        follower.accept(new OrderReport(verdict, state, reply, pose.get()));
    }

    /** The call is over: its orders get no further reply. */
    void end() {
        ended = true;
    }

    boolean isEnded() {
        return ended;
    }
}

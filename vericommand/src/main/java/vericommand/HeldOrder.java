package vericommand;

import java.util.Optional;

/** An order that has ended the robot's own process and waits for the robot to stand before it is verified. */
final class HeldOrder {
    private final Recognition.Complete recognition;
    private final OrderOrigin source;
    private boolean stopOrdered;

    HeldOrder(Recognition.Complete recognition, OrderOrigin source) {
        this.recognition = recognition;
        this.source = source;
    }

    Recognition.Complete recognition() {
        return recognition;
    }

    OrderOrigin source() {
        return source;
    }

    void orderStop() {
        stopOrdered = true;
    }

    boolean isStopOrdered() {
        return stopOrdered;
    }

    /** Of its first motion nothing is done; empty for an order that moves nothing. */
    Optional<OrderProgress> firstProgress() {
        var instructions = recognition.order().instructions();
        return instructions.stream()
                .filter(Instruction.Motion.class::isInstance)
                .map(Instruction.Motion.class::cast)
                .findFirst()
                .map(motion -> new OrderProgress(motion, 0, instructions.indexOf(motion) + 1, instructions.size()));
    }
}

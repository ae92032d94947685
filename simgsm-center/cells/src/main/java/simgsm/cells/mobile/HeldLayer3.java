package simgsm.cells.mobile;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import simgsm.abis.RslMessage;

/** Holds layer 3 of a terminal and its tower while the mobile changes channels or its signal is too weak. */
final class HeldLayer3 {
    /**
     * Maximum per direction; further messages are dropped. The terminal's time-outs end the transaction much earlier.
     */
    private static final int MOST = 1_000;

    private final Queue<RslMessage.DataIndication> up = new ArrayDeque<>();
    private final Queue<RslMessage.DataRequest> down = new ArrayDeque<>();
    private final BooleanSupplier isReachable;
    private final Consumer<RslMessage.DataIndication> tower;
    private final Consumer<RslMessage.DataRequest> terminal;

    /** @param isReachable true if messages get through now; a passed message may change it */
    HeldLayer3(
            BooleanSupplier isReachable,
            Consumer<RslMessage.DataIndication> tower,
            Consumer<RslMessage.DataRequest> terminal) {
        this.isReachable = isReachable;
        this.tower = tower;
        this.terminal = terminal;
    }

    /** Passes a message of the terminal now or later. */
    void add(RslMessage.DataIndication message) {
        add(message, up);
    }

    /** Passes a message of the tower now or later. */
    void add(RslMessage.DataRequest message) {
        add(message, down);
    }

    private <M> void add(M message, Queue<M> queue) {
        if (queue.size() < MOST) {
            queue.add(message);
        }
        pass();
    }

    /** Passes all permitted messages, messages of the terminal first. */
    void pass() {
        passUp();
        pass(down, terminal);
    }

    void passUp() {
        pass(up, tower);
    }

    private <M> void pass(Queue<M> queue, Consumer<M> receiver) {
        while (!queue.isEmpty() && isReachable.getAsBoolean()) {
            receiver.accept(queue.remove());
        }
    }

    void clear() {
        up.clear();
        down.clear();
    }
}

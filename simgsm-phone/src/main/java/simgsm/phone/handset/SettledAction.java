package simgsm.phone.handset;

import java.util.function.BooleanSupplier;

/** An action that runs once, as soon as a condition holds. */
final class SettledAction {
    private final BooleanSupplier isSettled;
    private Runnable action;

    SettledAction(BooleanSupplier isSettled) {
        this.isSettled = isSettled;
    }

    /** Sets the action, and runs it now if the condition holds. */
    void set(Runnable next) {
        action = next;
        check();
    }

    /** Runs the action if the condition holds; call it whenever the condition may have changed. */
    void check() {
        if (action != null && isSettled.getAsBoolean()) {
            Runnable due = action;
            action = null;
            due.run();
        }
    }
}

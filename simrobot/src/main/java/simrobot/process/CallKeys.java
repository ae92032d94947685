package simrobot.process;

import simrobot.behaviour.Call;
import simrobot.behaviour.Senses;

/** The call of a robot as its process hears it. Owned by the robot's owner thread. */
public final class CallKeys {
    /** Limit for a process that decides late. */
    private static final int MOST_KEPT = 16;

    private String caller = "";
    private char held = Senses.NO_KEY;
    private String pressed = "";

    /** Nobody has called. */
    public CallKeys() {}

    /** Earlier keys are forgotten. @param number who has called, or has started a process; empty if it is not known */
    public void begin(String number) {
        caller = number;
        held = Senses.NO_KEY;
        pressed = "";
    }

    /** A key was recognised. */
    public void press(char key) {
        held = key;
        pressed = (pressed + key).substring(Math.max(0, pressed.length() + 1 - MOST_KEPT));
    }

    /** The newest key was released. */
    public void release() {
        held = Senses.NO_KEY;
    }

    /** Takes the call for this decision, with the keys pressed since the last one. */
    public Call take() {
        boolean tapped = held == Senses.NO_KEY && !pressed.isEmpty();
        Call call = new Call(caller, tapped ? pressed.charAt(pressed.length() - 1) : held, pressed);
        pressed = "";
        return call;
    }
}

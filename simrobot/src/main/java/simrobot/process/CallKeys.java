package simrobot.process;

import simrobot.behaviour.Senses;

/** The call of a robot as its process hears it: the caller and the keys. Owned by the robot's owner thread. */
public final class CallKeys {
    /** Of a process that decides late, the newest keys are kept. */
    private static final int MOST_KEPT = 16;

    private final StringBuilder pressed = new StringBuilder();
    private char held = Senses.NO_KEY;
    private String caller = "";

    /** No call is up. */
    public CallKeys() {}

    /** A call is up. @param from empty if the network does not say */
    public void begin(String from) {
        end();
        caller = from;
    }

    /** The call has ended. */
    public void end() {
        caller = "";
        clear();
    }

    /** A process begins: earlier keys are not its own. */
    public void clear() {
        pressed.setLength(0);
        held = Senses.NO_KEY;
    }

    /** A key is decided. */
    public void press(char key) {
        held = key;
        pressed.append(key);
        pressed.delete(0, Math.max(0, pressed.length() - MOST_KEPT));
    }

    /** The key that was pressed last sounds no longer. */
    public void release() {
        held = Senses.NO_KEY;
    }

    /** The key held, else the one pressed last since {@link #takePressed}. */
    public char key() {
        return held != Senses.NO_KEY || pressed.isEmpty() ? held : pressed.charAt(pressed.length() - 1);
    }

    /** The keys pressed since the last call, in their order. */
    public String takePressed() {
        String taken = pressed.toString();
        pressed.setLength(0);
        return taken;
    }

    /** Empty without a call, and if the network does not say. */
    public String caller() {
        return caller;
    }
}

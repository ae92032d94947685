package blackbox;

import simgsm.abis.IpaFrame;

/** Observes a {@link VirtualSuite} while it runs; by default does nothing. */
public interface SuiteTrace {
    SuiteTrace NONE = new SuiteTrace() {};

    /** A frame crosses the link of a terminal. */
    default void frame(String terminal, boolean isUplink, IpaFrame frame) {}

    /** The centre and its journal or disk exchange something; both sides by name. */
    default void stored(String from, String to, String what) {}

    /** The robot's console prints a line. */
    default void robotLine(String line) {}

    /** A speech frame's time, 20 ms, has passed and all that it caused is done. */
    default void frameTimeOver() {}
}

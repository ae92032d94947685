package simrobot.source.child;

import java.util.concurrent.Callable;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.BehaviourAnswer;
import simrobot.behaviour.Senses;

/** Has students' processes decide on one thread, which a {@link Watchdog} watches, and says where and why one fails. */
public abstract class Decider {
    private volatile long decision;
    private volatile FaultPlace place = new FaultPlace("");

    /** Watches this thread, which makes all decisions. */
    protected final void watch() {
        new Watchdog(this, Thread.currentThread()).start();
    }

    /** Counts the beginnings and ends of decisions: odd while one is being made. */
    protected final long decision() {
        return decision;
    }

    /** The line of the student's file that a thread executes; 0 if it executes none. */
    protected final int line(StackTraceElement[] trace) {
        return place.line(trace);
    }

    /** Makes one decision: calls {@link #decided} or {@link #failed}. @param process creates it, if necessary */
    protected final void decide(FaultPlace lines, Callable<Behaviour> process, Senses senses) {
        place = lines;
        try {
            BehaviourAnswer made = answer(process, senses);
            if (made.steering() == null) {
                failed(0, "null", "decide returned null, expected a Steering");
            } else {
                decided(made);
            }
        } catch (Throwable thrown) {
            Throwable cause = FaultPlace.cause(thrown);
            failed(lines.line(cause.getStackTrace()), cause.getClass().getSimpleName(), FaultPlace.text(cause));
        }
    }

    private BehaviourAnswer answer(Callable<Behaviour> process, Senses senses) throws Exception {
        decision++;
        try {
            return BehaviourAnswer.of(process.call(), senses);
        } finally {
            decision++;
        }
    }

    /** Ends the virtual machine at once, and the programs that the student's file has started. */
    protected static void halt(int status) {
        try {
            ProcessHandle.current().descendants().forEach(ProcessHandle::destroyForcibly);
        } finally {
            Runtime.getRuntime().halt(status);
        }
    }

    /** A process has decided. @param made with a steering */
    protected abstract void decided(BehaviourAnswer made);

    /** A decision has failed. @param cause names a hint */
    protected abstract void failed(int line, String cause, String text);

    /** Reports a fault and ends the virtual machine. Called on the watchdog's thread. @param cause names a hint */
    protected abstract void end(StackTraceElement[] trace, String cause, String text);
}

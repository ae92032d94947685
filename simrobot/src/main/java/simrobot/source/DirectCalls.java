package simrobot.source;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntToDoubleFunction;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.BehaviourAnswer;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import simrobot.process.Decision;
import simrobot.process.RobotProcess;
import simrobot.source.child.Decider;
import simrobot.source.child.FaultPlace;
import simrobot.source.child.LoadedClasses;
import simrobot.source.child.PipeSenses;

/**
 * Calls students' Java processes on the simulation's own thread, for runs without a clock: a child costs many times the time of a
 * decision. A decision takes effect 50 ms later, as with a child. What a fault does to SimRobot ends the run, and the program.
 */
final class DirectCalls extends Decider {
    private final Consumer<Decision.Failed> ended;
    /** The robot that decides, or has decided last; null before the first. */
    private volatile OfRobot deciding;

    private volatile boolean isClosed;

    /**
     * Begins to watch this thread.
     *
     * @param ended told of an endless decision, an exit or a thread that runs on; then the program ends
     */
    DirectCalls(Consumer<Decision.Failed> ended) {
        this.ended = ended;
        watch();
    }

    RobotProcess ofRobot(Class<? extends Behaviour> type, ChildFile source, FaultPlace lines) {
        return new OfRobot(type, source, lines);
    }

    void close() {
        isClosed = true;
    }

    @Override
    protected void decided(BehaviourAnswer made) {
        deciding.next =
                made.isDone() ? new Decision.Done(made.asked()) : new Decision.Go(made.steering(), made.asked());
    }

    @Override
    protected void failed(int line, String cause, String text) {
        deciding.next = deciding.source.failed(line, cause, text, List.of());
    }

    @Override
    protected void end(StackTraceElement[] trace, String cause, String text) {
        int line = line(trace);
        boolean isOwnExit = cause.equals("exit") && line == 0 && decision() % 2 == 0;
        if (isClosed || isOwnExit) {
            return;
        }
        try {
            ended.accept(deciding.source.failed(line, cause, text, List.of()));
        } finally {
            halt(1);
        }
    }

    /** Returns ranges with millimetres, as those that children read; refused after the decision, when the robot has moved. */
    private IntToDoubleFunction during(long asked, IntToDoubleFunction live) {
        return i -> {
            if (decision() != asked) {
                throw new IllegalStateException("senses of an earlier decision: keep their numbers, not the Senses");
            }
            return Math.round(live.applyAsDouble(i) * 1000) / 1000.0;
        };
    }

    /** The process of one robot. */
    private final class OfRobot implements RobotProcess {
        private final Class<? extends Behaviour> type;
        private final ChildFile source;
        private final FaultPlace lines;
        /** Null before the first decision. */
        private Behaviour behaviour;

        private Decision next = new Decision.Go(Steering.STOP);

        OfRobot(Class<? extends Behaviour> type, ChildFile source, FaultPlace lines) {
            this.type = type;
            this.source = source;
            this.lines = lines;
        }

        @Override
        public long periodNanos() {
            return BehaviourChild.PERIOD_NANOS;
        }

        @Override
        public Decision decide(Senses senses) {
            Decision now = next;
            if (!(now instanceof Decision.End)) {
                deciding = this;
                long asked = decision() + 1;
                DirectCalls.this.decide(lines, this::behaviour, PipeSenses.of(senses, live -> during(asked, live)));
            }
            return now;
        }

        private Behaviour behaviour() throws Exception {
            if (behaviour == null) {
                behaviour = LoadedClasses.create(type);
            }
            return behaviour;
        }
    }
}

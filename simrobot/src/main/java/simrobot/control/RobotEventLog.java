package simrobot.control;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.LongSupplier;
import simrobot.behaviour.BehaviourKind;
import vericommand.Reply;
import vericommand.RobotStatus;
import vericommand.Verdict;

/** The newest events of all robots, bounded; old ones make room. Filled on the simulation's thread, read by any. */
public final class RobotEventLog {
    /** Some hours of a class, some seconds of a crowd. */
    public static final int CAPACITY = 2000;

    private final LongSupplier timeNanos;
    private final Deque<LoggedEvent> events = new ArrayDeque<>();
    private List<LoggedEvent> published = List.of();
    private boolean changed;

    /** @param timeNanos the simulated time, asked on the simulation's thread */
    public RobotEventLog(LongSupplier timeNanos) {
        this.timeNanos = timeNanos;
    }

    /** The oldest first; the same object as long as nothing has happened. */
    public synchronized List<LoggedEvent> newest() {
        if (changed) {
            published = List.copyOf(events);
            changed = false;
        }
        return published;
    }

    public synchronized void clear() {
        events.clear();
        changed = true;
    }

    private void add(String robot, LoggedEvent.Kind kind, String what, String text) {
        LoggedEvent event = new LoggedEvent(timeNanos.getAsLong(), robot, kind, what, text);
        synchronized (this) {
            if (events.size() == CAPACITY) {
                events.removeFirst();
            }
            events.addLast(event);
            changed = true;
        }
    }

    public void added(TelephoneRobot robot) {
        add(robot.name(), LoggedEvent.Kind.ADDED, robot.number().digits(), "");
    }

    public void removed(TelephoneRobot robot) {
        add(robot.name(), LoggedEvent.Kind.REMOVED, "", "");
    }

    /** Writes down what happens around this robot. */
    public ControlListener of(String robot) {
        return new ControlListener() {
            @Override
            public void registered(String number) {
                add(robot, LoggedEvent.Kind.REGISTERED, number, "");
            }

            @Override
            public void unregistered(String cause) {
                add(robot, LoggedEvent.Kind.UNREGISTERED, cause, "");
            }

            @Override
            public void call(String from) {
                add(robot, LoggedEvent.Kind.CALL, from, "");
            }

            @Override
            public void order(Verdict verdict) {
                add(robot, LoggedEvent.Kind.ORDER, verdict.keys(), verdict.word());
            }

            @Override
            public void outcome(Reply reply) {
                add(robot, LoggedEvent.Kind.OUTCOME, String.valueOf(reply.tone().number()), reply.text());
            }

            @Override
            public void replySent(String to, String text) {
                add(robot, LoggedEvent.Kind.REPLY, to, text);
            }

            @Override
            public void message(String from, String text) {
                add(robot, LoggedEvent.Kind.MESSAGE, from, text);
            }

            @Override
            public void released(int cause) {
                add(robot, LoggedEvent.Kind.RELEASED, String.valueOf(cause), "");
            }

            @Override
            public void behaviour(BehaviourKind kind) {
                add(robot, LoggedEvent.Kind.BEHAVIOUR, kind.name(), "");
            }

            @Override
            public void status(RobotStatus status) {
                add(robot, LoggedEvent.Kind.STATUS, status.name(), "");
            }
        };
    }
}

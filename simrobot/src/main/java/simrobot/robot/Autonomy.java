package simrobot.robot;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simrobot.behaviour.Request;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.process.CallKeys;
import simrobot.process.Decision;
import simrobot.process.Errand;
import simrobot.process.RobotProcess;
import simrobot.world.Position;
import vericommand.RobotStatus;
import vericommand.StatusEvent;

/**
 * The autonomous process in a robot: it sets the drive's speeds at the process's period until it ends by itself or is ended
 * by an order, a P2OS client's motion command, a brake or a switch. Ending it brakes the robot with its deceleration. While
 * a process runs, a robot that stands without touching anything is Moving.
 */
public final class Autonomy {
    /** A process that leaves its robot in Collision for this time does not handle it. */
    static final long COLLISION_NANOS = 3_000_000_000L;

    /** Learns how a process ended. */
    public interface EndListener {
        /** Called on the owner thread: of a process that ended by itself when the robot stands. */
        void ended(BehaviourKind kind, Decision.End how);
    }

    private final Pioneer robot;
    private final List<Consumer<BehaviourKind>> listeners = new CopyOnWriteArrayList<>();
    private final List<EndListener> endListeners = new CopyOnWriteArrayList<>();
    private final List<BiConsumer<BehaviourKind, Request>> requestListeners = new CopyOnWriteArrayList<>();
    private BehaviourKind kind = BehaviourKind.NONE;
    /** Null if none runs. */
    private RobotProcess process;

    private ProcessSenses senses;
    private final CallKeys call = new CallKeys();
    private boolean takesKeys;
    private Errand errand = Errand.NONE;
    private List<Request.Mark> marks = List.of();
    /** Of a process that has ended by itself, until the robot stands; else null. */
    private Decision.End ending;

    private BehaviourList choice = new BehaviourList();
    /** The processes by number, as the robot named them last. */
    private SortedMap<Integer, BehaviourKind> announced = new TreeMap<>();

    private long sinceDecisionNanos;
    private long inCollisionNanos;
    /** Called once the robot stands; null if no order waits for that. */
    private Runnable standListener;

    /** The process of a robot, none at first. */
    Autonomy(Pioneer robot) {
        this.robot = robot;
    }

    public BehaviourKind kind() {
        return kind;
    }

    public boolean isActive() {
        return process != null;
    }

    /** Whether the robot counts as Moving although it may stand. */
    public boolean isUnfinished() {
        return process != null && ending == null;
    }

    /** The processes that orders can start are those of this list. */
    public void setChoice(BehaviourList behaviours) {
        choice = behaviours;
    }

    /** The names of the processes that orders can start, by number. */
    public SortedMap<Integer, String> processes() {
        SortedMap<Integer, String> names = new TreeMap<>();
        announced = choice.numbered();
        announced.forEach((number, process) -> names.put(number, process.text()));
        return names;
    }

    /**
     * Begins the process that had this number when {@link #processes} was last called, in status Stopped: the list may have
     * changed since, on another thread.
     *
     * @param from the number of who has ordered it
     */
    public void begin(int number, String from) {
        if (!begin(announced.get(number))) {
            throw new IllegalStateException("process " + number + " is not possible in "
                    + robot.status().text());
        }
        call.begin(from);
    }

    /** The way that the process is about to take; empty if it plans none. */
    public List<Position> path() {
        RobotProcess driver = errand == Errand.NONE ? process : errand.route();
        return isUnfinished() ? driver.path() : List.of();
    }

    /** What its process has drawn on the floor; a new list at every change. */
    public List<Request.Mark> marks() {
        return marks;
    }

    /** The robot's call, for its process. */
    public CallKeys call() {
        return call;
    }

    /** Whether the running process has asked for the keys of the call. */
    public boolean takesKeys() {
        return isUnfinished() && takesKeys;
    }

    /** Adds a listener for all that processes ask for, after each decision, on the owner thread. */
    public void addRequestListener(BiConsumer<BehaviourKind, Request> listener) {
        requestListeners.add(listener);
    }

    /** Adds a listener for the new kind at every change, on the owner thread. */
    public void addListener(Consumer<BehaviourKind> listener) {
        listeners.add(listener);
    }

    /** Adds a listener for the end of every process. */
    public void addEndListener(EndListener listener) {
        endListeners.add(listener);
    }

    /**
     * Begins a process in place of the running one; {@link BehaviourKind#NONE} only ends that.
     *
     * @return false, with nothing changed, if the robot has no motors or executes an order
     */
    public boolean begin(BehaviourKind next) {
        if (next.equals(BehaviourKind.NONE)) {
            end();
            return true;
        }
        if (!robot.hasMotors() || robot.isUnderOrder()) {
            return false;
        }
        change(next, next.begin(robot.surroundings()).orElse(null), new Decision.Replaced());
        prepare();
        return true;
    }

    /**
     * Goes on with the new version of the running process; the process has not ended by that. Nothing happens if another one
     * runs, or this one has ended by itself already.
     */
    public void renew(BehaviourKind version) {
        if (!isUnfinished() || !kind.equals(version)) {
            return;
        }
        RobotProcess old = process;
        kind = version;
        process = version.begin(robot.surroundings()).orElseThrow();
        old.close();
        prepare();
    }

    private void prepare() {
        call.take();
        takesKeys = false;
        errand = Errand.NONE;
        marks = List.of();
        senses = new ProcessSenses(robot, call::take, () -> errand.hasArrived());
        inCollisionNanos = 0;
        if (isActive()) {
            sinceDecisionNanos = process.periodNanos();
            countAsMoving();
        }
    }

    /** Sets the kind that is shown, for a replay; no process runs. */
    void show(BehaviourKind shown) {
        kind = shown;
    }

    /** Ends the process, if one runs; the robot slows down until it stands. */
    public void end() {
        if (isActive()) {
            robot.stopSteering();
            change(BehaviourKind.NONE, null, new Decision.Replaced());
        }
    }

    /** Ends the process for an order. @param listener called once the robot stands */
    public void endFor(Runnable listener) {
        end();
        standListener = listener;
        notifyIfStanding();
    }

    /** Whether an order waits until the robot stands. */
    public boolean isAwaited() {
        return standListener != null;
    }

    private void notifyIfStanding() {
        if (standListener != null && robot.status() != RobotStatus.MOVING) {
            Runnable listener = standListener;
            standListener = null;
            listener.run();
        }
    }

    /** @param how the running process ends, if one runs */
    private void change(BehaviourKind next, RobotProcess started, Decision.End how) {
        BehaviourKind before = kind;
        RobotProcess ended = process;
        kind = next;
        process = started;
        ending = null;
        if (ended != null) {
            ended.close();
        }
        if (!next.equals(before)) {
            listeners.forEach(listener -> listener.accept(next));
        }
        if (ended != null) {
            endListeners.forEach(listener -> listener.ended(before, how));
        }
    }

    /** A process begins to steer a robot that is Stopped: it is Moving until the process ends, also while it stands. */
    private void countAsMoving() {
        if (robot.status() == RobotStatus.STOPPED) {
            robot.change(StatusEvent.MOTION_STARTED);
        }
    }

    /** A step of time, before the robot moves through it. */
    public void step(long nanos) {
        notifyIfStanding();
        if (ending != null) {
            concludeIfStanding();
        }
        if (!isUnfinished()) {
            return;
        }
        countAsMoving();
        senses.elapse(nanos);
        inCollisionNanos = robot.status() == RobotStatus.COLLISION ? inCollisionNanos + nanos : 0;
        sinceDecisionNanos += nanos;
        if (inCollisionNanos > COLLISION_NANOS) {
            perform(new Decision.Collided());
        } else if (sinceDecisionNanos >= process.periodNanos()) {
            // a real robot is heard of less often than some processes decide
            sinceDecisionNanos = Math.min(sinceDecisionNanos - process.periodNanos(), process.periodNanos());
            perform(driven(process.decide(senses)));
        }
    }

    /** The decision, with the speeds of the way to the place for which it asks. */
    private Decision driven(Decision decision) {
        List<Request.Drive> drives =
                decision instanceof Decision.Go go ? requests(go.asked(), Request.Drive.class) : List.of();
        if (drives.isEmpty()) {
            errand = Errand.NONE;
            return decision;
        }
        String place = drives.get(0).place();
        if (!errand.place().equals(place)) {
            try {
                RobotProcess route = choice.toPlace(place).begin(robot.surroundings()).orElseThrow();
                errand = new Errand(place, route);
            } catch (IllegalArgumentException unknown) {
                return new Decision.Failed(0, "goTo: " + unknown.getMessage());
            }
        }
        return errand.step((Decision.Go) decision, senses, process.periodNanos());
    }

    private static <R extends Request> List<R> requests(List<Request> asked, Class<R> type) {
        return asked.stream().filter(type::isInstance).map(type::cast).toList();
    }

    private void note(List<Request> asked) {
        takesKeys |= asked.contains(new Request.Keys());
        List<Request.Mark> drawn = requests(asked, Request.Mark.class);
        if (!drawn.isEmpty()) {
            List<Request.Mark> all = Stream.concat(marks.stream(), drawn.stream()).toList();
            marks = all.subList(Math.max(0, all.size() - Request.Mark.MOST), all.size());
        }
        asked.forEach(request -> requestListeners.forEach(listener -> listener.accept(kind, request)));
    }

    private void perform(Decision decision) {
        if (decision instanceof Decision.Go go) {
            note(go.asked());
            robot.steer(go.steering());
        } else {
            ending = (Decision.End) decision;
            note(ending.asked());
            robot.stopSteering();
            concludeIfStanding();
        }
    }

    private void concludeIfStanding() {
        if (robot.status() != RobotStatus.MOVING) {
            change(BehaviourKind.NONE, null, ending);
        }
    }
}

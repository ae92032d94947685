package simrobot.robot;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simrobot.behaviour.BehaviourRequest;
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
 * The autonomous process in a robot: sets the drive's speeds at the process's period until it ends by itself or is
 * ended by an order, a P2OS client's motion command, a brake or a switch. Its end brakes the robot with its
 * deceleration. While a process runs, a robot at rest without contact is Moving.
 */
public final class Autonomy {
    /** Time in Collision after which a process is ended. */
    static final long COLLISION_NANOS = 3_000_000_000L;

    /** Is told the end of processes. */
    public interface EndListener {
        /** Called on the owner thread; after a process has ended by itself, once the robot has stopped. */
        void ended(BehaviourKind kind, Decision.End how);
    }

    private final Pioneer robot;
    private final List<Consumer<BehaviourKind>> listeners = new CopyOnWriteArrayList<>();
    private final List<EndListener> endListeners = new CopyOnWriteArrayList<>();
    private final List<BiConsumer<BehaviourKind, BehaviourRequest>> requestListeners = new CopyOnWriteArrayList<>();
    private BehaviourKind kind = BehaviourKind.NONE;
    /** Null if none runs. */
    private RobotProcess process;

    private ProcessSenses senses;
    private final CallKeys call = new CallKeys();
    private boolean takesKeys;
    /** The newest of the process; null before it requests a place. */
    private Errand errand;

    private List<BehaviourRequest.Mark> marks = List.of();
    /** The decision that ended the process, until the robot has stopped; else null. */
    private Decision.End ending;

    private BehaviourList choice = new BehaviourList();
    /** The processes by number, as the robot named them last. */
    private SortedMap<Integer, BehaviourKind> announced = new TreeMap<>();

    private long sinceDecisionNanos;
    private long inCollisionNanos;
    /** Called once the robot has stopped; null if no order waits for that. */
    private Runnable standListener;

    /** Creates a robot's autonomy without a process. */
    Autonomy(Pioneer robot) {
        this.robot = robot;
    }

    public BehaviourKind kind() {
        return kind;
    }

    public boolean isActive() {
        return process != null;
    }

    /** True if the robot counts as Moving although it may have stopped. */
    public boolean isUnfinished() {
        return process != null && ending == null;
    }

    /** Sets the list of processes that orders can start. */
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
     * Begins the process with this number at the last call of {@link #processes}, in status Stopped: another thread may
     * have changed the list since.
     *
     * @param from number of the operator
     */
    public void begin(int number, String from) {
        if (!begin(announced.get(number))) {
            throw new IllegalStateException("process " + number + " is not possible in "
                    + robot.status().text());
        }
        call.begin(from);
    }

    /** The planned path of the process; may be empty. */
    public List<Position> path() {
        List<Position> toPlace = errand == null ? List.of() : errand.path();
        return !isUnfinished() ? List.of() : toPlace.isEmpty() ? process.path() : toPlace;
    }

    /** The process's drawing on the floor; a new list at every change. */
    public List<BehaviourRequest.Mark> marks() {
        return marks;
    }

    /** The robot's call, for its process. */
    public CallKeys call() {
        return call;
    }

    /** True once the robot has reached the place that the process requested last. */
    boolean hasArrived() {
        return errand != null && errand.hasArrived();
    }

    /** True if the running process reads the keys of the call. */
    public boolean takesKeys() {
        return isUnfinished() && takesKeys;
    }

    /** Adds a listener for the requests of processes, called after each decision on the owner thread. */
    public void addRequestListener(BiConsumer<BehaviourKind, BehaviourRequest> listener) {
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
     * Replaces the running process by its new version, which is no end of the process. Does nothing if another one
     * runs, or this one has already ended by itself.
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
        errand = null;
        marks = List.of();
        senses = new ProcessSenses(robot);
        inCollisionNanos = 0;
        if (isActive()) {
            sinceDecisionNanos = process.periodNanos();
            countAsMoving();
        }
    }

    /** Sets the displayed kind, for a replay; no process runs. */
    void show(BehaviourKind shown) {
        kind = shown;
    }

    /** Ends the process, if one runs; the robot decelerates to rest. */
    public void end() {
        if (isActive()) {
            robot.stopSteering();
            change(BehaviourKind.NONE, null, new Decision.Replaced());
        }
    }

    /**
     * Ends the process for an order.
     *
     * @param listener called once the robot has stopped
     */
    public void endFor(Runnable listener) {
        end();
        standListener = listener;
        notifyIfStanding();
    }

    /** True if an order waits for the robot to stop. */
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

    /** Changes Stopped to Moving: a steered robot is Moving until its process ends, even at rest. */
    private void countAsMoving() {
        if (robot.status() == RobotStatus.STOPPED) {
            robot.change(StatusEvent.MOTION_STARTED);
        }
    }

    /** Advances by a step of time, before the robot moves. */
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
            // a real robot reports less often than some processes decide
            sinceDecisionNanos = Math.min(sinceDecisionNanos - process.periodNanos(), process.periodNanos());
            perform(driven(process.decide(senses)));
        }
    }

    /** Replaces the speeds of a decision by those of the route to a requested place. */
    private Decision driven(Decision decision) {
        if (errand != null) {
            errand.elapse(process.periodNanos());
        }
        if (!(decision instanceof Decision.Go go) || go.asked().isEmpty()) {
            return decision;
        }
        List<BehaviourRequest.DriveTo> drives = requests(go.asked(), BehaviourRequest.DriveTo.class);
        if (drives.isEmpty()) {
            return decision;
        }
        String place = drives.get(0).place();
        if (errand == null || !errand.isFor(place)) {
            try {
                RobotProcess route =
                        choice.toPlace(place).begin(robot.surroundings()).orElseThrow();
                errand = new Errand(place, route);
            } catch (IllegalArgumentException unknown) {
                return new Decision.Failed(0, "goTo: " + unknown.getMessage());
            }
        }
        return errand.step(go, senses);
    }

    private static <R extends BehaviourRequest> List<R> requests(List<BehaviourRequest> asked, Class<R> type) {
        return asked.stream().filter(type::isInstance).map(type::cast).toList();
    }

    private void note(List<BehaviourRequest> asked) {
        if (asked.isEmpty()) {
            return;
        }
        takesKeys |= asked.contains(new BehaviourRequest.Keys());
        List<BehaviourRequest.Mark> drawn = requests(asked, BehaviourRequest.Mark.class);
        if (!drawn.isEmpty()) {
            List<BehaviourRequest.Mark> all =
                    Stream.concat(marks.stream(), drawn.stream()).toList();
            marks = all.subList(Math.max(0, all.size() - BehaviourRequest.Mark.MOST), all.size());
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

package simrobot.app.window;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Predicate;
import simgsm.air.Msisdn;
import simgsm.speech.CallMonitor;
import simgsm.tone.ToneExperiment;
import simrobot.app.SessionRecording;
import simrobot.app.WorldFile;
import simrobot.app.ports.ClientRequests;
import simrobot.app.ports.ListeningPorts;
import simrobot.control.Fleet;
import simrobot.control.RobotEvent;
import simrobot.control.RobotEventLog;
import simrobot.control.RobotName;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.process.BehaviourKind;
import simrobot.robot.Pioneer;
import simrobot.robot.Placement;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.simulation.SimulationThread;
import simrobot.ui.OpenPort;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.floor.SnapshotComparison;
import simrobot.ui.inspector.RefusalTexts;
import simrobot.world.MapWriter;
import simrobot.world.World;
import vericommand.Pose;

/** The running program for the window: combines the snapshots of all threads and passes actions to their owners. */
public final class WindowModel extends SessionModel {
    private static final Logger LOG = System.getLogger(WindowModel.class.getName());

    private static final long CLOCK_NANOS = 1_000_000_000;

    private final SimulationThread simulation;
    /** On the event thread. */
    private SimulationSnapshot scene;

    private final CallMonitor callMonitor;
    private final Fleet fleet;
    private final ListeningPorts ports;
    private final RobotEventLog log;
    private final SessionRecording recording;
    private final List<SessionRecording> recordings = new CopyOnWriteArrayList<>();
    private List<SessionRecording.Failure> recordingFailures = List.of();
    private final RefusalTexts refusals;
    private final List<Line> lines = new CopyOnWriteArrayList<>();
    private final WorldFileWatch watch;
    private final RecentWorlds recent;
    private final DraftFiles drafts = new DraftFiles();
    private volatile Path worldFile;
    private volatile OptionalDouble resolutionMeters = OptionalDouble.empty();

    /** A robot with its modem, and the tones that it has sent. */
    private record Line(TelephoneRobot robot, SentTones sent) {}

    /** Listens to the robots, so it is created before the start. */
    public WindowModel(
            SimRobot simRobot,
            Fleet fleet,
            ListeningPorts ports,
            Path worldFile,
            RecentWorlds recent,
            RefusalTexts refusals) {
        super(simRobot.simulation(), simRobot.tracks()::csv, refusals);
        this.recent = recent;
        this.refusals = refusals;
        this.worldFile = worldFile;
        watch = new WorldFileWatch(worker(), worldFile);
        this.fleet = fleet;
        this.ports = ports;
        simulation = simRobot.simulation();
        scene = simulation.snapshot();
        callMonitor = simRobot.callMonitor();
        recording = new SessionRecording(simulation);
        recordings.add(recording);
        log = new RobotEventLog(() -> simulation.isOwner() ? simulation.owned().timeNanos() : 0);
        ports.setWorldLoader(file -> read(file, ClientRequests::mayLoad, () -> {}));
        simRobot.onAdded(this::added);
        simRobot.onRemoved(this::removed);
    }

    private void added(TelephoneRobot robot) {
        Line line = new Line(robot, new SentTones());
        robot.listen(line.sent());
        robot.listen(event -> log.add(robot.name(), event));
        robot.listen(recording.listener(robot.name()));
        log.add(robot.name(), new RobotEvent.Added(robot.number().digits()));
        lines.add(line);
    }

    private void removed(TelephoneRobot robot) {
        lines.removeIf(line -> line.robot() == robot);
        log.add(robot.name(), new RobotEvent.Removed(robot.number().digits()));
    }

    /** Reports when a recording of another part, such as {@code --record}, fails. */
    public void watch(SessionRecording other) {
        recordings.add(other);
    }

    /** The width of a pixel of pictures loaded from now on. */
    public void setResolution(OptionalDouble meters) {
        resolutionMeters = meters;
    }

    @Override
    WindowSnapshot observe() {
        tellOfFailure();
        return new WindowSnapshot(
                scene(),
                lines.stream().map(this::snapshot).toList(),
                simulation.speed(),
                simulation.isPaused(),
                worldFile,
                notice(""),
                openPorts(),
                log.newest(),
                Optional.empty(),
                recording.file(),
                watch.hasChanged());
    }

    /** At rest the same object for a second of simulated time. */
    private SimulationSnapshot scene() {
        SimulationSnapshot now = simulation.snapshot();
        if (simulation.isPaused()
                || now.timeNanos() / CLOCK_NANOS != scene.timeNanos() / CLOCK_NANOS
                || !SnapshotComparison.looksTheSame(scene, now)) {
            scene = now;
        }
        return scene;
    }

    /** Reports the failure of a recording once. */
    private void tellOfFailure() {
        List<SessionRecording.Failure> failures = recordings.stream()
                .flatMap(running -> running.failure().stream())
                .toList();
        for (SessionRecording.Failure ended : failures) {
            if (!recordingFailures.contains(ended)) {
                tell(refusals.unwritable(ended.file(), ended.why()));
            }
        }
        recordingFailures = failures;
    }

    private List<OpenPort> openPorts() {
        List<OpenPort> open = new ArrayList<>();
        for (Line line : lines) {
            String name = line.robot().name();
            ports.p2os(name).ifPresent(port -> open.add(new OpenPort("P2OS", name, port)));
        }
        ports.http().ifPresent(port -> open.add(new OpenPort("HTTP", "", port)));
        return open;
    }

    private TelephoneSnapshot snapshot(Line line) {
        TelephoneRobot robot = line.robot();
        return new TelephoneSnapshot(
                robot.name(),
                robot.number().digits(),
                robot.modem(),
                robot.heard(),
                robot.veriCommand(),
                line.sent().keys(),
                line.sent().words(),
                callMonitor.isAudible());
    }

    /** Performs an act on a robot, if it exists. */
    private void act(String name, Consumer<Pioneer> act) {
        simulation.post(() -> robot(name).map(TelephoneRobot::robot).ifPresent(act));
    }

    private Optional<TelephoneRobot> robot(String name) {
        return lines.stream()
                .map(Line::robot)
                .filter(robot -> robot.name().equals(name))
                .findFirst();
    }

    @Override
    public void setPower(String robot, boolean on) {
        act(robot, owned -> owned.setPower(on));
    }

    @Override
    public void setMotors(String robot, boolean on) {
        act(robot, owned -> owned.setMotors(on));
    }

    @Override
    public void place(String robot, double xMeters, double yMeters, double headingRadians, Consumer<Placement> answer) {
        simulation.post(
                () -> robot(robot).ifPresent(owned -> answer.accept(owned.place(xMeters, yMeters, headingRadians))));
    }

    @Override
    public void tryOut(String robot, ToneExperiment experiment) {
        robot(robot).ifPresent(named -> named.tryOut(experiment));
    }

    @Override
    public void addRobot(String name, String number, Optional<Pose> place, Consumer<Optional<String>> answer) {
        worker().execute(() -> answer.accept(add(name, number, place)));
    }

    private Optional<String> add(String name, String number, Optional<Pose> place) {
        Msisdn called;
        try {
            called = Msisdn.parse(number).plain();
        } catch (IllegalArgumentException noNumber) {
            return Optional.of(refusals.noNumber(number));
        }
        try {
            return add(new RobotName(name, called), place);
        } catch (IllegalArgumentException noName) {
            return Optional.of(refusals.noName(name));
        }
    }

    private Optional<String> add(RobotName wanted, Optional<Pose> place) {
        try {
            fleet.add(wanted, place);
            return Optional.empty();
        } catch (Fleet.RobotRefusal refusal) {
            LOG.log(Level.DEBUG, "not added: {0}", refusal.getMessage());
            return Optional.of(refusals.notAdded(wanted.name(), wanted.number().digits(), refusal));
        } catch (IOException unwritable) {
            return Optional.of(String.valueOf(unwritable.getMessage()));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return Optional.of(refusals.late());
        }
    }

    @Override
    public void removeRobot(String robot) {
        worker().execute(() -> {
            try {
                fleet.remove(robot);
            } catch (IllegalStateException e) {
                LOG.log(Level.WARNING, "{0} stays: {1}", robot, e.getMessage());
                tell(refusals.late());
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
    }

    @Override
    public void brake(String robot) {
        act(robot, Pioneer::brake);
    }

    @Override
    public void setBehaviour(String robot, BehaviourKind kind) {
        act(robot, owned -> {
            if (!owned.autonomy().begin(kind)) {
                tell(refusals.process(robot, kind, owned.status()));
            }
        });
    }

    @Override
    public void watch(String robot) {
        callMonitor.select(robot);
        simulation.withSimulation(owned -> owned.watch(owned.robot(robot).orElse(null)));
    }

    @Override
    public void load(Path file) {
        worker().execute(() -> {
            Path place = WorldFile.find(Optional.of(file));
            read(place, owned -> true, () -> worker().execute(() -> recent.add(place)));
        });
    }

    @Override
    public List<Path> recentWorlds() {
        return recent.files();
    }

    @Override
    public void apply(World world, Path file, Consumer<Optional<String>> answer) {
        simulation.withSimulation(owned -> {
            try {
                int moved = owned.change(world);
                worldFile = file;
                watch.setCurrent(file);
                tell("");
                answer.accept(Optional.empty());
                if (moved > 0) {
                    LOG.log(Level.INFO, moved + " robots overlapped the changed world and were moved to homes");
                }
            } catch (IllegalArgumentException tooSmall) {
                answer.accept(Optional.of(refusals.tooSmall(world.name())));
            }
        });
    }

    @Override
    public void save(World world, Path file, Consumer<Optional<String>> answer) {
        worker().execute(() -> {
            try {
                MapWriter.save(world, file);
                if (file.equals(worldFile)) {
                    watch.setCurrent(file);
                }
                recent.add(file);
                answer.accept(Optional.empty());
            } catch (IOException unwritable) {
                answer.accept(Optional.of(refusals.unwritable(file, unwritable)));
            }
        });
    }

    @Override
    public void keep(World draft, Path file) {
        drafts.keep(draft, file, worker());
    }

    @Override
    public void dropKept(Path file) {
        drafts.drop(file);
    }

    /** Loads a world; an unreadable file changes nothing and is reported. */
    void read(Path file) {
        read(file, owned -> true, () -> {});
    }

    /** @param loaded run on the simulation's thread once the robots are in that world */
    private void read(Path file, Predicate<Simulation> permitted, Runnable loaded) {
        try {
            World world = WorldFile.read(Optional.of(file), resolutionMeters);
            simulation.withSimulation(owned -> {
                if (!permitted.test(owned)) {
                    return;
                }
                try {
                    owned.load(world);
                    worldFile = file;
                    watch.setCurrent(file);
                    tell("");
                    loaded.run();
                } catch (IllegalArgumentException tooSmall) {
                    tell(refusals.tooSmall(world.name()));
                }
            });
        } catch (IOException unreadable) {
            recent.leaveOut(file);
            tell(refusals.unreadable(file, unreadable));
        }
    }

    @Override
    public void record(Optional<Path> file) {
        recording.restart(file, (path, why) -> tell(refusals.unwritable(path, why)));
    }

    /** The number of the only robot, or how many robots there are. */
    public String title() {
        return "SimRobot " + (lines.size() == 1 ? lines.get(0).robot().number().digits() : "(" + lines.size() + ")");
    }
}

package simrobot.control;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.console.FatalError;
import simgsm.modem.Modem;
import simgsm.modem.ModemOptions;
import simgsm.modem.at.AtProfile;
import simgsm.modem.at.command.AtModem;
import simgsm.modem.at.command.ModemTerminal;
import simgsm.modem.at.port.AtPort;
import simgsm.modem.client.AttachedModem;
import simgsm.modem.client.SoundPort;
import simgsm.modem.line.ModemLine;
import simgsm.sim.InsertedCard;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallAudioListener;
import simgsm.speech.CallMonitor;
import simgsm.station.StationOptions;
import simgsm.station.StationThread;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;
import simgsm.thread.DaemonThread;
import simrobot.process.BehaviourList;
import simrobot.robot.Pioneer;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.simulation.SimulationThread;
import vericommand.VeriCommandSettings;

/**
 * The program without console and windows: the simulation with its thread, robots with their verifiers, and modems with
 * their thread.
 */
public final class SimRobot implements AutoCloseable {
    /** Maximum wait for a task: tasks take milliseconds, an ended simulation performs none. */
    private static final Duration PATIENCE = Duration.ofSeconds(5);

    private static final String UNIT_NAME = "SimGSM robot";

    private final Simulation simulation;
    private final SimulationThread simulationThread;
    private final StationThread stationThread = new StationThread("modems", cause -> FatalError.end("simrobot", cause));
    private final InetSocketAddress center;
    private final VeriCommandSettings settings;
    private final ControlThreads drivers;
    private final Duration patience;
    private final List<TelephoneRobot> robots = new CopyOnWriteArrayList<>();
    private final Map<TelephoneRobot, ModemConnection> connections = new ConcurrentHashMap<>();
    private final List<Consumer<TelephoneRobot>> told = new CopyOnWriteArrayList<>();
    private final List<Consumer<TelephoneRobot>> toldOfLeaving = new CopyOnWriteArrayList<>();
    private final List<Runnable> goodbyes = new CopyOnWriteArrayList<>();
    private final CallMonitor callMonitor;
    private final TrackLog tracks;
    private final ExecutorService planning = DaemonThread.executor("route planner");
    private volatile boolean started;

    /**
     * Creates a stopped instance: add robots, then {@link #start}.
     *
     * @param output plays the calls; closed by {@link #close}
     */
    public SimRobot(Simulation simulation, InetSocketAddress center, VeriCommandSettings settings, AudioOutput output) {
        this(simulation, center, settings, output, PATIENCE);
    }

    SimRobot(
            Simulation simulation,
            InetSocketAddress center,
            VeriCommandSettings settings,
            AudioOutput output,
            Duration patience) {
        callMonitor = new CallMonitor(output);
        this.center = center;
        this.settings = settings;
        this.patience = patience;
        this.simulation = simulation;
        simulationThread = new SimulationThread(simulation);
        simulation.destinations().setExecutor(planning);
        tracks = new TrackLog(simulation);
        drivers = new ControlThreads(stationThread::execute, simulationThread, System::nanoTime);
    }

    /**
     * Adds a modem for an open network and a verifier to a robot; after the start on the simulation's thread.
     *
     * @throws IllegalArgumentException if another robot has the number
     */
    public TelephoneRobot add(Pioneer robot, Msisdn number, Imei imei, ModemOptions options) {
        return add(robot, StationIdentity.ofOpenNumber(number, imei, UNIT_NAME), Sim.WITHOUT_KEY, options);
    }

    /** Adds a robot whose modem has a SIM card. */
    public TelephoneRobot add(Pioneer robot, InsertedCard card, Imei imei, ModemOptions options) {
        return add(robot, StationIdentity.ofCard(card.card(), imei, UNIT_NAME), Sim.of(card), options);
    }

    private TelephoneRobot add(Pioneer robot, StationIdentity identity, Sim sim, ModemOptions options) {
        requireFree(identity.number());
        StationOptions station = options.station();
        CallAudioListener listener = CallAudioListener.both(station.recorder(), callMonitor.listener(robot.name()));
        ModemOptions heard = new ModemOptions(
                new StationOptions(station.codec(), listener),
                options.answerAfterMillis(),
                options.prompts(),
                options.voices());
        TelephoneRobot added = new TelephoneRobot(robot, identity, sim, heard, settings, drivers);
        join(
                added,
                new ModemConnection(
                        () -> stationThread.add(added.station(), center),
                        () -> stationThread.remove(added.station(), station.recorder()::close),
                        station.recorder()::close));
        return added;
    }

    /**
     * Opens a port for AT commands to a robot's M2; it is served once the program runs.
     *
     * @return nothing for a robot behind a real modem
     * @throws IOException naming address and port
     */
    public Optional<AtPort> openAtPort(TelephoneRobot robot, InetSocketAddress address, AtProfile profile)
            throws IOException {
        if (robot.m2().isEmpty()) {
            return Optional.empty();
        }
        Modem m2 = robot.m2().get();
        AtModem modem = new AtModem(new ModemTerminal(m2), profile, InstantSource.system());
        AtPort port = AtPort.open(modem, m2.station(), stationThread, address);
        m2.observe(port::accept);
        return Optional.of(port);
    }

    /**
     * Adds a robot with a real modem, before the start.
     *
     * @param number the SIM's
     * @param options without the codec, which is the modem's
     * @throws IllegalArgumentException if another robot has the number
     */
    TelephoneRobot addBehind(RealModem modem, Pioneer robot, Msisdn number, ModemOptions options) {
        requireFree(number);
        String name = "modem of " + robot.name();
        ModemLine line = new ModemLine(name, modem.address(), cause -> FatalError.end("simrobot", cause));
        Optional<ModemLine> sound = modem.sound().map(second -> new ModemLine("sound of the " + name, second, line));
        CallAudioListener recorder = options.station().recorder();
        CallAudioListener heard =
                modem.isPlayed() ? CallAudioListener.both(recorder, callMonitor.listener(robot.name())) : recorder;
        SoundPort port = sound.map(
                        second -> new SoundPort(second::sendFrame, heard, options.prompts(), options.voices()))
                .orElse(SoundPort.NONE);
        TelephoneRobot added = new TelephoneRobot(
                robot,
                number,
                (admission, listener) -> {
                    AttachedModem core = new AttachedModem(
                            number, options.answerAfterMillis(), Instant.now(), line::send, port, admission, listener);
                    modem.pin().ifPresent(core::setPin);
                    sound.ifPresent(second -> second.attach(core.sound()));
                    return line.attach(core);
                },
                settings,
                new ControlThreads(line::execute, simulationThread, System::nanoTime));
        List<ModemLine> lines = Stream.concat(Stream.of(line), sound.stream()).toList();
        join(
                added,
                new ModemConnection(() -> lines.forEach(ModemLine::start), () -> lines.forEach(ModemLine::end), () -> {
                    lines.forEach(ModemLine::close);
                    recorder.close();
                }));
        return added;
    }

    private void requireFree(Msisdn number) {
        if (robots.stream().anyMatch(other -> other.number().equals(number))) {
            throw new IllegalArgumentException("another robot has the number " + number + ", expected a free one");
        }
    }

    private void join(TelephoneRobot added, ModemConnection connection) {
        connections.put(added, connection);
        tracks.follow(added.robot());
        added.listen(event -> {
            if (event instanceof RobotEvent.BehaviourFailed failed) {
                behaviours().setFault(new BehaviourList.Fault(failed.name(), failed.line(), failed.text()));
            }
        });
        told.forEach(each -> each.accept(added));
        robots.add(added);
        if (started) {
            connection.begin().run();
        }
    }

    /** Removes a robot from the simulation and its modem from the network; on the simulation's thread. */
    void remove(TelephoneRobot robot) {
        if (robots.remove(robot)) {
            robot.simulated().ifPresent(simulationThread.owned()::removeRobot);
            toldOfLeaving.forEach(each -> each.accept(robot));
            tracks.forget(robot.robot());
            connections.remove(robot).end().run();
        }
    }

    /**
     * Adds a listener, before the start: called now for each present robot, and on the simulation's thread for each new
     * one before its modem starts.
     */
    public void onAdded(Consumer<TelephoneRobot> listener) {
        robots.forEach(listener);
        told.add(listener);
    }

    /** Adds a listener, called on the simulation's thread for each robot removed. */
    public void onRemoved(Consumer<TelephoneRobot> listener) {
        toldOfLeaving.add(listener);
    }

    /** Adds an action that {@link #close} performs first, while all threads run. */
    void onClose(Runnable goodbye) {
        goodbyes.add(goodbye);
    }

    /** Starts the simulation and connects the modems to their centre. */
    public void start() {
        started = true;
        simulationThread.start();
        stationThread.start();
        robots.forEach(robot -> connections.get(robot).begin().run());
    }

    /** Returns the robots; the first is the default of commands without a name. */
    public List<TelephoneRobot> robots() {
        return List.copyOf(robots);
    }

    /** Returns the robot of this name. */
    public Optional<TelephoneRobot> robot(String name) {
        return robots.stream().filter(robot -> robot.name().equals(name)).findFirst();
    }

    /** Returns the processes that robots can run. */
    public BehaviourList behaviours() {
        return simulation.behaviours();
    }

    /** Returns the robots' tracks. */
    public TrackLog tracks() {
        return tracks;
    }

    /** Returns the audio monitor, which plays the calls of the selected robot. */
    public CallMonitor callMonitor() {
        return callMonitor;
    }

    /** Returns the simulation's thread: pace, pause and snapshots; tasks on robots are posted to it. */
    public SimulationThread simulation() {
        return simulationThread;
    }

    /** Returns the current state of the simulation; for the simulation's thread only. */
    public SimulationSnapshot scene() {
        return simulation.snapshot();
    }

    /** Returns {@link #scene} with the robots' laser ranges; for the simulation's thread only. */
    public SimulationSnapshot sceneWithLasers() {
        return simulation.snapshotWithLasers();
    }

    /**
     * Performs a task on the simulation's thread and waits for it.
     *
     * @throws IllegalStateException if the task failed, or was cancelled because it had not begun within 5 s
     */
    public <T> T onSimulation(Callable<T> act) throws InterruptedException {
        FutureTask<T> task = new FutureTask<>(act);
        simulationThread.post(task);
        try {
            return task.get(patience.toNanos(), TimeUnit.NANOSECONDS);
        } catch (ExecutionException e) {
            throw new IllegalStateException("the simulation has failed at it: " + e.getCause(), e.getCause());
        } catch (TimeoutException e) {
            task.cancel(false);
            throw new IllegalStateException(
                    "the simulation does not answer, expected an answer within " + seconds(patience) + " s", e);
        }
    }

    private static String seconds(Duration duration) {
        return Double.toString(duration.toMillis() / 1000.0).replaceFirst("\\.0$", "");
    }

    /** Detaches the modems, then ends the simulation. */
    @Override
    public void close() {
        goodbyes.forEach(Runnable::run);
        stationThread.close();
        connections.values().forEach(connection -> connection.close().run());
        callMonitor.close();
        simulationThread.close();
        planning.shutdownNow();
    }
}

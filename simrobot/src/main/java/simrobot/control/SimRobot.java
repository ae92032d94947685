package simrobot.control;

import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.console.FatalError;
import simgsm.sim.SimCard;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallAudioListener;
import simgsm.speech.CallMonitor;
import simgsm.station.StationOptions;
import simgsm.station.StationThread;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;
import simrobot.robot.Pioneer;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.simulation.SimulationThread;
import vericommand.VeriCommandSettings;

/**
 * The whole program below its console or window: a simulation with its thread, robots with their verifiers, modems with
 * theirs.
 */
public final class SimRobot implements AutoCloseable {
    /** An act is done within milliseconds; a simulation that has ended does none. */
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
    private final Map<TelephoneRobot, CallAudioListener> recorders = new ConcurrentHashMap<>();
    private final List<Consumer<TelephoneRobot>> told = new CopyOnWriteArrayList<>();
    private final List<Consumer<TelephoneRobot>> toldOfLeaving = new CopyOnWriteArrayList<>();
    private final List<Runnable> goodbyes = new CopyOnWriteArrayList<>();
    private final CallMonitor callMonitor;
    private final TrackLog tracks;
    private volatile boolean started;

    /**
     * Nothing runs yet: add robots, then {@link #start}.
     *
     * @param output where calls are heard; closed with the rest
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
        tracks = new TrackLog(simulation);
        drivers = new ControlThreads(stationThread::execute, simulationThread, System::nanoTime);
    }

    /**
     * Gives a robot its modem, for an open network, and its verifier; after the start on the simulation's thread.
     *
     * @throws IllegalArgumentException when another robot has the number
     */
    public TelephoneRobot add(Pioneer robot, Msisdn number, Imei imei, StationOptions options) {
        return add(robot, StationIdentity.ofOpenNumber(number, imei, UNIT_NAME), Sim.WITHOUT_KEY, options);
    }

    /** As before, with a card in the modem's slot. */
    public TelephoneRobot add(Pioneer robot, SimCard card, Imei imei, StationOptions options) {
        return add(robot, StationIdentity.ofCard(card, imei, UNIT_NAME), Sim.of(card), options);
    }

    private TelephoneRobot add(Pioneer robot, StationIdentity identity, Sim sim, StationOptions options) {
        if (robots.stream().anyMatch(other -> other.number().equals(identity.number()))) {
            throw new IllegalArgumentException(
                    "another robot has the number " + identity.number() + ", expected a free one");
        }
        CallAudioListener listener = CallAudioListener.both(options.recorder(), callMonitor.listener(robot.name()));
        StationOptions heard = new StationOptions(options.codec(), listener);
        TelephoneRobot added = new TelephoneRobot(robot, identity, sim, heard, settings, drivers);
        recorders.put(added, options.recorder());
        tracks.follow(robot);
        told.forEach(each -> each.accept(added));
        robots.add(added);
        if (started) {
            stationThread.add(added.station(), center);
        }
        return added;
    }

    /** Takes a robot off the floor and its modem off the network; on the simulation's thread. */
    void remove(TelephoneRobot robot) {
        if (robots.remove(robot)) {
            robot.simulated().ifPresent(simulationThread.owned()::removeRobot);
            toldOfLeaving.forEach(each -> each.accept(robot));
            tracks.forget(robot.robot());
            CallAudioListener recorder = recorders.remove(robot);
            stationThread.remove(robot.station(), recorder::close);
        }
    }

    /**
     * Who is told of each robot before its modem begins: at once of those that are there, then, on the simulation's
     * thread, of those that come. To be said before the start.
     */
    public void onAdded(Consumer<TelephoneRobot> listener) {
        robots.forEach(listener);
        told.add(listener);
    }

    /** Who is told, on the simulation's thread, of each robot that has left the floor. */
    public void onRemoved(Consumer<TelephoneRobot> listener) {
        toldOfLeaving.add(listener);
    }

    /** What is done first of all at the end, while all threads still run. */
    void onClose(Runnable goodbye) {
        goodbyes.add(goodbye);
    }

    /** Time begins and the modems look for their centre. */
    public void start() {
        started = true;
        simulationThread.start();
        stationThread.start();
        robots.forEach(robot -> stationThread.add(robot.station(), center));
    }

    /** The first robot is the one that is meant when nobody says which. */
    public List<TelephoneRobot> robots() {
        return List.copyOf(robots);
    }

    /** The robot of this name. */
    public Optional<TelephoneRobot> robot(String name) {
        return robots.stream().filter(robot -> robot.name().equals(name)).findFirst();
    }

    /** Where the robots have been. */
    public TrackLog tracks() {
        return tracks;
    }

    /** Where calls are heard: of several robots the one that is chosen. */
    public CallMonitor callMonitor() {
        return callMonitor;
    }

    /** Pace, pause and pictures of the world; acts on robots are posted to it. */
    public SimulationThread simulation() {
        return simulationThread;
    }

    /** The simulation as it is at this moment; for the simulation's thread only. */
    public SimulationSnapshot scene() {
        return simulation.snapshot();
    }

    /**
     * Has something done on the simulation's thread and waits for it.
     *
     * @throws IllegalStateException when it failed, or when the simulation has not come to it in 5 s; then it will not be done
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
        recorders.values().forEach(CallAudioListener::close);
        callMonitor.close();
        simulationThread.close();
    }
}

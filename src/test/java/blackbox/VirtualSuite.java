package blackbox;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.LongConsumer;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.center.msc.Exchange;
import simgsm.center.subscriber.HomeRegister;
import simgsm.modem.ModemOptions;
import simgsm.modem.at.AtProfile;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.context.StationIdentity;
import simgsm.station.mobility.Sim;
import simrobot.control.ControlThreads;
import simrobot.control.TelephoneRobot;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.World;
import vericommand.VeriCommandSettings;

/**
 * The whole suite in one thread with a clock moved by hand: the real exchange, phones, modem, verifier and robot. Frames
 * are handed over in memory in the order in which they were sent, time moves in speech frames of 20 ms, so minutes of a
 * call take moments and every run is the same.
 */
public final class VirtualSuite {
    public static final String ROBOT = "5550200";
    public static final String PHONE = "5550100";
    private static final long FRAME_NANOS = 20_000_000;

    /** The console lines of the robot. */
    final List<String> robotLines = new ArrayList<>();

    public final SimulatedRobot robot;
    public final TelephoneRobot telephone;
    public final Simulation simulation;
    private final Deque<Runnable> underWay = new ArrayDeque<>();
    private final SplittableRandom equipment = new SplittableRandom(1);
    private final List<VirtualLink> links = new ArrayList<>();
    private final List<VirtualModem> modems = new ArrayList<>();
    private final VirtualCenter center;
    private final SuiteTrace trace;
    private final List<LongConsumer> clocks = new ArrayList<>();
    private long nowNanos;

    /** The modem answers at once. */
    VirtualSuite() {
        this(VeriCommandSettings.OnHangup.STOP);
    }

    /** The modem rings. */
    VirtualSuite(int answerAfterMillis) {
        this(
                SuiteTrace.NONE,
                HomeRegister.OPEN,
                Optional.empty(),
                answerAfterMillis,
                VeriCommandSettings.OnHangup.STOP);
    }

    VirtualSuite(VeriCommandSettings.OnHangup onHangup, String... operators) {
        this(SuiteTrace.NONE, HomeRegister.OPEN, Optional.empty(), 0, onHangup, operators);
    }

    /**
     * An observed suite.
     *
     * @param journal the folder of the centre's journal; without it messages are kept in memory
     */
    public VirtualSuite(SuiteTrace trace, HomeRegister home, Optional<Path> journal) {
        this(trace, home, journal, 0, VeriCommandSettings.OnHangup.STOP);
    }

    /** With the robot in a world, at its first home, and its texts in a language. The modem rings. */
    public VirtualSuite(World world, int answerAfterMillis, Locale language) {
        this(
                new Simulation(world, 1),
                SuiteTrace.NONE,
                HomeRegister.OPEN,
                Optional.empty(),
                answerAfterMillis,
                new VeriCommandSettings(language, Set.of(), VeriCommandSettings.OnHangup.STOP));
    }

    private VirtualSuite(
            SuiteTrace trace,
            HomeRegister home,
            Optional<Path> journal,
            int answerAfterMillis,
            VeriCommandSettings.OnHangup onHangup,
            String... operators) {
        this(
                new Simulation(World.bare(), 1),
                trace,
                home,
                journal,
                answerAfterMillis,
                new VeriCommandSettings(Locale.ENGLISH, Set.of(operators), onHangup));
    }

    private VirtualSuite(
            Simulation simulation,
            SuiteTrace trace,
            HomeRegister home,
            Optional<Path> journal,
            int answerAfterMillis,
            VeriCommandSettings settings) {
        this.simulation = simulation;
        this.trace = trace;
        center = new VirtualCenter(underWay, () -> nowNanos, trace, home, journal);
        robot = simulation.addRobot("robot");
        telephone = new TelephoneRobot(
                robot,
                identity(ROBOT, "SimGSM robot"),
                Sim.WITHOUT_KEY,
                new ModemOptions(StationOptions.STANDARD, answerAfterMillis),
                settings,
                new ControlThreads(underWay::add, underWay::add, () -> nowNanos));
        telephone.listen(event -> robotLine(event.line("robot").toString()));
        connect(telephone.station());
    }

    private void robotLine(String line) {
        robotLines.add(line);
        trace.robotLine(line);
    }

    /** Kills the centre's process and starts another; every link breaks and is made again. */
    public void restartCenter() {
        underWay.clear();
        center.start();
        links.forEach(VirtualLink::down);
        seconds(2);
        links.forEach(VirtualLink::up);
        seconds(0.5);
    }

    /** The centre's core; all links lead to it. */
    public Exchange exchange() {
        return center.exchange();
    }

    public long nowNanos() {
        return nowNanos;
    }

    /** A phone that has registered. */
    public VirtualPhone phone(String number) {
        return phone(number, Sim.WITHOUT_KEY);
    }

    /** A phone with this card; it registers where the network takes the card. */
    public VirtualPhone phone(String number, Sim sim) {
        VirtualPhone phone = new VirtualPhone(this, identity(number, "SimGSM phone"), sim);
        phone.link = connect(phone.station());
        return phone;
    }

    /** A modem with its AT commands that has registered. It rings until ATA. */
    VirtualModem modem(String number) {
        return modem(number, AtProfile.PLAIN);
    }

    VirtualModem modem(String number, AtProfile profile) {
        VirtualModem modem = new VirtualModem(this, identity(number, "SimGSM modem"), profile);
        modems.add(modem);
        modem.link = connect(modem.station());
        return modem;
    }

    /** A phone in a call with the robot that has heard the first tone. */
    VirtualPhone inCall() {
        VirtualPhone phone = phone(PHONE);
        phone.dial(ROBOT);
        seconds(0.5);
        return phone;
    }

    /** The lines of the robot's console that begin so. */
    List<String> robotLines(String beginning) {
        return robotLines.stream().filter(line -> line.startsWith(beginning)).toList();
    }

    public void seconds(double seconds) {
        for (long frame = Math.round(seconds * 50); frame > 0; frame--) {
            for (long step = 0; step < FRAME_NANOS; step += Simulation.STEP_NANOS) {
                nowNanos += Simulation.STEP_NANOS;
                simulation.step();
            }
            links.forEach(link -> link.station.timePassed(nowNanos));
            modems.forEach(modem -> modem.timePassed(nowNanos));
            clocks.forEach(clock -> clock.accept(nowNanos));
            exchange().advance(nowNanos);
            settle();
            trace.frameTimeOver();
        }
    }

    /** What was sent arrives, and what that brings about, until all is quiet. */
    public void settle() {
        for (Runnable next = underWay.poll(); next != null; next = underWay.poll()) {
            next.run();
        }
    }

    /** Queues what happens after the present event, as at the arrival of a message. */
    void later(Runnable action) {
        underWay.add(action);
    }

    /** Tells the time of each frame of 20 ms. */
    void tellTime(LongConsumer clock) {
        clocks.add(clock);
    }

    /** Links a station that another core has made. */
    void join(MobileStation station) {
        VirtualLink link = new VirtualLink(station, this::exchange, underWay, () -> nowNanos, trace);
        links.add(link);
        link.up();
    }

    private StationIdentity identity(String number, String unitName) {
        return StationIdentity.ofOpenNumber(new Msisdn(number), Imei.random(equipment), unitName);
    }

    private VirtualLink connect(MobileStation station) {
        VirtualLink link = new VirtualLink(station, this::exchange, underWay, () -> nowNanos, trace);
        links.add(link);
        link.up();
        seconds(0.1);
        return link;
    }
}

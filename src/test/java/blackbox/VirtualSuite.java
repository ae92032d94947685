package blackbox;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.SplittableRandom;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeSettings;
import simgsm.station.MobileStation;
import simgsm.station.Sim;
import simgsm.station.StationIdentity;
import simgsm.station.StationOptions;
import simrobot.control.ControlThreads;
import simrobot.control.RobotEventPrinter;
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
final class VirtualSuite {
    static final String ROBOT = "5550200";
    static final String PHONE = "5550100";
    private static final long FRAME_NANOS = 20_000_000;

    /** The console lines of the robot. */
    final List<String> robotLines = new ArrayList<>();

    final SimulatedRobot robot;
    private final Deque<Runnable> underWay = new ArrayDeque<>();
    private final SplittableRandom equipment = new SplittableRandom(1);
    private final List<VirtualLink> links = new ArrayList<>();
    private final Simulation simulation = new Simulation(World.bare(), 1);
    private final Exchange exchange = new Exchange(
            new ExchangeSettings("SimGSM", 1, Instant.parse("2026-11-21T12:00:00Z")),
            (ticket, entries) -> commit(ticket),
            event -> {});
    private long nowNanos;

    VirtualSuite() {
        this(VeriCommandSettings.OnHangup.STOP);
    }

    VirtualSuite(VeriCommandSettings.OnHangup onHangup, String... operators) {
        robot = simulation.addRobot("robot");
        TelephoneRobot telephone = new TelephoneRobot(
                robot,
                identity(ROBOT, "SimGSM robot"),
                Sim.WITHOUT_KEY,
                StationOptions.STANDARD,
                new VeriCommandSettings(Locale.ENGLISH, Set.of(operators), onHangup),
                new ControlThreads(underWay::add, underWay::add, () -> nowNanos));
        telephone.listen(new RobotEventPrinter("robot", event -> robotLines.add(event.toString())));
        connect(telephone.station());
    }

    /** A phone that has registered. */
    VirtualPhone phone(String number) {
        VirtualPhone phone = new VirtualPhone(this, identity(number, "SimGSM phone"));
        phone.link = connect(phone.station());
        return phone;
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

    void seconds(double seconds) {
        for (long frame = Math.round(seconds * 50); frame > 0; frame--) {
            for (long step = 0; step < FRAME_NANOS; step += Simulation.STEP_NANOS) {
                nowNanos += Simulation.STEP_NANOS;
                simulation.step();
            }
            links.forEach(link -> link.station.timePassed(nowNanos));
            exchange.advance(nowNanos);
            settle();
        }
    }

    /** What was sent arrives, and what that brings about, until all is quiet. */
    void settle() {
        for (Runnable next = underWay.poll(); next != null; next = underWay.poll()) {
            next.run();
        }
    }

    private StationIdentity identity(String number, String unitName) {
        return StationIdentity.ofOpenNumber(new Msisdn(number), Imei.random(equipment), unitName);
    }

    private VirtualLink connect(MobileStation station) {
        VirtualLink link = new VirtualLink(station, exchange, underWay, () -> nowNanos);
        links.add(link);
        link.up();
        seconds(0.1);
        return link;
    }

    private void commit(long ticket) {
        underWay.add(() -> exchange.committed(nowNanos, ticket, true));
    }
}

package blackbox;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.UnaryOperator;
import simgsm.air.Msisdn;
import simgsm.modem.client.AttachedModem;
import simgsm.modem.client.SoundPort;
import simrobot.control.ControlThreads;
import simrobot.control.TelephoneRobot;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.World;
import vericommand.VeriCommandSettings;

/** A robot behind an emulated modem, in one thread with a clock moved by hand in steps of 10 ms. */
final class RealModemScene {
    static final String CALLER = "5550100";
    /** Earlier than the emulated modem's messages. */
    private static final Instant START = Instant.parse("2026-11-22T00:00:00Z");

    final EmulatedModem modem;
    final SimulatedRobot robot;
    /** The lines of the robot's console. */
    final List<String> lines = new ArrayList<>();

    private final Simulation simulation = new Simulation(World.bare(), 1);
    private final Deque<Runnable> underWay = new ArrayDeque<>();
    private final TelephoneRobot telephone;
    private AttachedModem attached;
    private long nowNanos;
    private boolean open;
    /** What the line makes of the modem's octets. */
    UnaryOperator<byte[]> line = UnaryOperator.identity();

    RealModemScene(EmulatedModem.Family family) {
        modem = new EmulatedModem(family, this::fromModem);
        robot = simulation.addRobot("robot");
        telephone = new TelephoneRobot(
                robot,
                new Msisdn("5550200"),
                (admission, listener) -> {
                    attached = new AttachedModem(
                            new Msisdn("5550200"), 1500, START, this::toModem, SoundPort.NONE, admission, listener);
                    return attached;
                },
                new VeriCommandSettings(Locale.ENGLISH, Set.of(), VeriCommandSettings.OnHangup.STOP),
                new ControlThreads(underWay::add, underWay::add, () -> nowNanos));
        telephone.listen(event -> lines.add(event.line("robot").toString()));
    }

    private void fromModem(byte[] octets) {
        if (open) {
            attached.received(line.apply(octets), nowNanos);
        }
    }

    private void toModem(String octets) {
        if (open) {
            modem.received(new String(octets.getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.ISO_8859_1));
        }
    }

    void openPort() {
        open = true;
        attached.lineUp(nowNanos);
    }

    void closePort() {
        open = false;
        attached.lineDown(nowNanos);
    }

    boolean inService() {
        return telephone.modem().registered();
    }

    void seconds(double seconds) {
        for (long step = Math.round(seconds * 100); step > 0; step--) {
            nowNanos += Simulation.STEP_NANOS;
            simulation.step();
            modem.advance(nowNanos);
            attached.timePassed(nowNanos);
            for (Runnable next = underWay.poll(); next != null; next = underWay.poll()) {
                next.run();
            }
        }
    }

    /** A scene whose modem is in service. */
    RealModemScene ready() {
        openPort();
        seconds(3);
        return this;
    }

    /** A scene in a call that has been accepted. */
    RealModemScene inCall() {
        modem.call(CALLER);
        seconds(3);
        return this;
    }

    /** Each key takes 150 ms. */
    void press(String keys) {
        for (char key : keys.replace(" ", "").toCharArray()) {
            modem.key(key);
            seconds(0.15);
        }
    }

    String tones() {
        return modem.tonesSent.toString();
    }

    List<String> lines(String beginning) {
        return lines.stream().filter(each -> each.startsWith(beginning)).toList();
    }

    double travelledMetres() {
        return Math.hypot(robot.xMeters(), robot.yMeters());
    }
}

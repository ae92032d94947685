package simrobot.control;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.Imei;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.Tmsi;
import simgsm.air.TransactionIdentifier;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.modem.Modem;
import simgsm.modem.ModemOptions;
import simgsm.octets.OctetString;
import simgsm.speech.SpeechCodec;
import simgsm.station.StationOptions;
import simgsm.station.context.StationIdentity;
import simgsm.station.context.Uplink;
import simgsm.station.mobility.Sim;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.VeriCommandSettings;

/**
 * An operator's telephone and the network played by hand before a real modem, verifier and simulated robot: keys go in as
 * sound, tones are heard in the sound that comes back, time moves in speech frames.
 */
final class TelephoneScene implements Uplink {
    static final Msisdn OPERATOR = new Msisdn("5550100");
    private static final TransactionIdentifier CALL = new TransactionIdentifier(3, false);
    private static final Tmsi TMSI = new Tmsi(0x1234abcd);
    private static final long FRAME_NANOS = 20_000_000;

    final List<String> lines = new ArrayList<>();
    final StringBuilder tonesHeard = new StringBuilder();
    final Simulation simulation = new Simulation(World.of("wall", List.of(new Segment(1, -2, 1, 2))), 1);
    final SimulatedRobot robot = simulation.addRobot("robot", new Position(0, 0), 0);
    final ModemLink<Modem> link;
    private final Queue<Layer3Message> sent = new ArrayDeque<>();
    private final SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
    private final DtmfGenerator fingers = new DtmfGenerator();
    private final DtmfReceiver ear =
            new DtmfReceiver(digit -> tonesHeard.append(digit.key().symbol()));
    /** When the wheels first moved for a motion, by the scene's clock. */
    long wheelsMovedNanos;

    long nowNanos = 1_000_000_000L;
    private final Queue<Runnable> heldBack = new ArrayDeque<>();
    private boolean simulationLate;
    private int sequence;
    private boolean speaking;

    TelephoneScene(String... operators) {
        StationIdentity identity =
                StationIdentity.ofOpenNumber(new Msisdn("5550200"), new Imei("490154203237518"), "SimGSM robot");
        ControlThreads drivers = new ControlThreads(Runnable::run, this::simulate, () -> nowNanos);
        ModemOptions options = new ModemOptions(StationOptions.STANDARD, 0);
        link = new ModemLink<>(
                (admission, listener) -> new Modem(identity, Sim.WITHOUT_KEY, options, admission, listener), drivers);
        VeriCommandSettings settings =
                new VeriCommandSettings(Locale.ENGLISH, Set.of(operators), VeriCommandSettings.OnHangup.STOP);
        RobotControl control = new RobotControl(robot, settings, link, () -> nowNanos);
        control.listen(event -> lines.add(event.line("robot").toString()));
        link.serve(control);
        robot.addFirstMotionListener(() -> wheelsMovedNanos = nowNanos);
        register();
    }

    private void simulate(Runnable act) {
        if (simulationLate) {
            heldBack.add(act);
        } else {
            act.run();
        }
    }

    /** From here on the robot's side does not hear what the modem tells, as on a busy machine. */
    void holdBackNews() {
        simulationLate = true;
    }

    void releaseNews() {
        simulationLate = false;
        heldBack.forEach(Runnable::run);
        heldBack.clear();
    }

    private void register() {
        link.modem().station().timePassed(nowNanos);
        link.modem().station().linkUp(this, nowNanos);
        frame(IpaFrame.CCM, CcmCodec.encode(new CcmMessage.IdentityRequest()));
        down(new LocationUpdatingAccept(LocationArea.TEST, Optional.of(TMSI)));
        down(new ChannelRelease(0));
        sent.clear();
    }

    /** The operator dials; whatever the modem decides, it answers. */
    void dial() {
        frame(IpaFrame.RSL, new RslMessage.PagingCommand(TMSI).encode());
        down(new CallControl.Setup(CALL, Optional.of(OPERATOR), Optional.empty()));
        down(new CallControl.ConnectAcknowledge(CALL));
        speaking = true;
    }

    void press(String keys) {
        DtmfKey.sequence(keys).forEach(key -> fingers.enqueue(key, 100, 100));
    }

    /** Presses keys of which the first has sounded already for a part of a frame, which is not sent. */
    void pressSince(int samples, String keys) {
        press(keys);
        fingers.read(new short[samples]);
    }

    /** The operator's phone vanishes: no speech comes any more, and nothing else. */
    void fallSilent() {
        speaking = false;
    }

    void hangUp() {
        down(new CallControl.Disconnect(CALL, Cause.NORMAL_CALL_CLEARING));
        down(new CallControl.ReleaseComplete(CALL, Optional.empty()));
        down(new ChannelRelease(0));
        speaking = false;
    }

    /** Lets time pass: the world's steps, then the speech frame that they took. */
    void seconds(double seconds) {
        for (int frame = (int) Math.round(seconds * 50); frame > 0; frame--) {
            for (int step = 0; step < FRAME_NANOS / Simulation.STEP_NANOS; step++) {
                nowNanos += Simulation.STEP_NANOS;
                simulation.step();
            }
            short[] samples = new short[160];
            fingers.read(samples);
            if (speaking) {
                byte[] octets = codec.encode(samples);
                frame(IpaFrame.SPEECH, new RtpPacket(8, sequence, sequence++ * 160L, 7, octets).encode());
            }
            link.modem().station().timePassed(nowNanos);
        }
    }

    /** The messages that the modem has sent since the last look. */
    List<String> messagesSent() {
        List<String> names =
                sent.stream().map(message -> message.getClass().getSimpleName()).toList();
        sent.clear();
        return names;
    }

    private void down(Layer3Message message) {
        OctetString octets = OctetString.of(Layer3Codec.encode(message, Direction.DOWNLINK, 0));
        frame(IpaFrame.RSL, new RslMessage.DataRequest(RslMessage.Sapi.SIGNALLING, octets).encode());
    }

    private void frame(int stream, byte[] payload) {
        link.modem().station().frameArrived(new IpaFrame(stream, payload), nowNanos);
    }

    @Override
    public void send(IpaFrame frame) {
        try {
            if (frame.stream() == IpaFrame.SPEECH) {
                ear.accept(codec.decode(RtpPacket.decode(frame.payload()).payload()));
            } else if (frame.stream() == IpaFrame.RSL) {
                note(RslMessage.decode(frame.payload()));
            }
        } catch (ProtocolViolation e) {
            fail(e);
        }
    }

    private void note(RslMessage message) throws ProtocolViolation {
        if (message instanceof RslMessage.EstablishIndication first) {
            sent.add(Layer3Codec.decode(first.layer3().toArray(), Direction.UPLINK));
        } else if (message instanceof RslMessage.DataIndication data) {
            sent.add(Layer3Codec.decode(data.layer3().toArray(), Direction.UPLINK));
        }
    }

    @Override
    public void drop() {
        fail("the modem dropped its link");
    }
}

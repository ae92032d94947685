package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.Supplier;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.abis.IpaFrame;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Message;
import simgsm.air.LocationArea;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement.CmServiceAccept;
import simgsm.air.MobilityManagement.CmServiceReject;
import simgsm.air.MobilityManagement.IdentityRequest;
import simgsm.air.MobilityManagement.LocationUpdatingAccept;
import simgsm.air.MobilityManagement.LocationUpdatingReject;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RejectCause;
import simgsm.air.RelayMessage.RpAck;
import simgsm.air.RelayMessage.RpData;
import simgsm.air.RelayMessage.RpError;
import simgsm.air.RpCause;
import simgsm.air.ShortMessageControl;
import simgsm.air.ShortMessageControl.CpAck;
import simgsm.air.ShortMessageControl.CpData;
import simgsm.air.ShortMessageControl.CpError;
import simgsm.air.SupplementaryService;
import simgsm.air.TransactionIdentifier;
import simgsm.octets.OctetString;
import simgsm.ss.Component;
import simgsm.ss.ComponentCodec;
import simgsm.ss.SsOperation;
import simgsm.ss.UssdText;
import simgsm.station.call.MobileCallTable.MobileCallState;

/** A network that sends whatever it likes, a user who does whatever he likes, and time. */
class RandomPeerTest {
    private static final int STEPS = 10_000;

    private final Scene scene = Scene.registered();
    private Random random;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void whateverComesTheStationStaysSoundAndEndsEachCallOnce(long seed) {
        random = new Random(seed);
        int begun = 0;
        int ended = 0;
        for (int step = 0; step < STEPS; step++) {
            doSomething();
            for (String line : scene.reported.lines()) {
                begun += line.startsWith("calling") || line.startsWith("ringing") ? 1 : 0;
                ended += line.startsWith("released") ? 1 : 0;
                assertTrue(begun == ended || begun == ended + 1, "step " + step + ": " + scene.reported.lines());
            }
            scene.reported.clear();
            scene.reported.heard.clear();
            scene.up.clear();
            scene.ccm.clear();
            scene.spoken.clear();
        }
        assertTrue(begun > 50, "only " + begun + " calls were begun");
        scene.station.powerOff();
        scene.pass(200 * Scene.SECOND);
        assertEquals(MobileCallState.NULL, scene.station.snapshot().callState());
        assertTrue(scene.station.isDetached());
    }

    private void doSomething() {
        switch (random.nextInt(40)) {
            case 0 -> scene.station.dial(Scene.OTHER);
            case 1 -> scene.station.hangUp();
            case 2 -> scene.station.answer();
            case 3 -> scene.station.sendMessage(Scene.OTHER, "x".repeat(random.nextInt(400)));
            case 4 -> scene.pass(random.nextInt(5) * Scene.SECOND);
            case 5 -> scene.page(scene.identity.imsi());
            case 6, 7, 8, 9 -> scene.down(new CmServiceAccept());
            case 10 -> rarely(scene.station::powerOff);
            case 11 -> scene.station.powerOn();
            case 12 -> rarely(scene::linkDown);
            case 13 -> relink();
            case 14 -> scene.down(new LocationUpdatingAccept(LocationArea.TEST, Optional.of(Scene.TMSI)));
            case 15, 16, 17 -> mutated();
            case 18 -> scene.station.sendUssd("*" + random.nextInt(200) + "#");
            case 19 -> rarely(scene.station::endUssd);
            case 20 -> scene.down(ussdMessage());
            default -> scene.down(anyMessage());
        }
    }

    /** A question, an answer or the end of a dialogue that may be under way. */
    private SupplementaryService ussdMessage() {
        TransactionIdentifier transaction = new TransactionIdentifier(random.nextInt(7), random.nextBoolean());
        OctetString question = ComponentCodec.encode(new Component.Invoke(
                1,
                random.nextBoolean() ? SsOperation.UNSTRUCTURED_SS_REQUEST : SsOperation.UNSTRUCTURED_SS_NOTIFY,
                UssdText.of("?").encode()));
        return switch (random.nextInt(3)) {
            case 0 -> new SupplementaryService.SsRegister(transaction, question, Optional.empty());
            case 1 -> new SupplementaryService.SsFacility(transaction, question);
            default -> new SupplementaryService.SsReleaseComplete(transaction);
        };
    }

    private void rarely(Runnable act) {
        if (random.nextInt(20) == 0) {
            act.run();
        }
    }

    private void relink() {
        if (!scene.station.snapshot().linkUp()) {
            scene.linkUp();
            scene.identify();
        }
    }

    private void mutated() {
        byte[] octets = Layer3Codec.encode(anyMessage(), Direction.DOWNLINK, 0);
        octets[random.nextInt(octets.length)] = (byte) random.nextInt();
        StringBuilder hex = new StringBuilder(OctetString.of(octets).toString());
        hex.setLength(Math.max(2, hex.length() - 2 * random.nextInt(3)));
        scene.downHex(hex.toString());
        byte[] payload = new byte[random.nextInt(30)];
        random.nextBytes(payload);
        scene.frame(List.of(IpaFrame.RSL, IpaFrame.CCM, IpaFrame.SPEECH, 7).get(random.nextInt(4)), payload);
    }

    private Layer3Message anyMessage() {
        TransactionIdentifier ti = new TransactionIdentifier(random.nextInt(7), random.nextBoolean());
        Cause cause = Cause.ofCode(random.nextInt(128));
        int reference = random.nextInt(256);
        List<Supplier<Layer3Message>> all = List.of(
                () -> new CallControl.Setup(ti, Optional.of(Scene.OTHER), Optional.empty()),
                () -> new CallControl.CallProceeding(ti),
                () -> new CallControl.Progress(ti),
                () -> new CallControl.Alerting(ti),
                () -> new CallControl.Connect(ti),
                () -> new CallControl.ConnectAcknowledge(ti),
                () -> new CallControl.StartDtmfAcknowledge(ti, '5'),
                () -> new CallControl.StopDtmfAcknowledge(ti),
                () -> new CallControl.Disconnect(ti, cause),
                () -> new CallControl.Release(ti, Optional.of(cause)),
                () -> new CallControl.ReleaseComplete(ti, Optional.empty()),
                () -> new CallControl.StatusEnquiry(ti),
                () -> new CallControl.Status(ti, cause, random.nextInt(3)),
                () -> new CmServiceReject(RejectCause.values()[random.nextInt(RejectCause.values().length)]),
                () -> new IdentityRequest(MobileIdentity.Type.IMEI),
                () -> new LocationUpdatingReject(RejectCause.ILLEGAL_MS),
                () -> new ChannelRelease(0),
                () -> new CpAck(ti),
                () -> new CpError(ti, 111),
                () -> new CpData(ti, new RpAck(reference, Optional.empty())),
                () -> new CpData(ti, new RpError(reference, RpCause.CONGESTION)),
                () -> new CpData(ti, new RpData(reference, Scene.OTHER, OctetString.ofHex("0400"))));
        Layer3Message chosen = all.get(random.nextInt(all.size())).get();
        return chosen instanceof ShortMessageControl || random.nextInt(4) > 0 ? chosen : new CmServiceAccept();
    }
}

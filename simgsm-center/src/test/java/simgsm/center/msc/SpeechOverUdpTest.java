package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simgsm.abis.IpaFrame;
import simgsm.abis.MediaPort;
import simgsm.abis.MgcpMessage;
import simgsm.abis.MgcpMessage.Head;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl;
import simgsm.air.ProtocolViolation;
import simgsm.center.bsc.handover.HandoverAlgorithm;
import simgsm.center.msc.link.NetworkTimer;
import simgsm.center.subscriber.HomeRegister;

/** The sessions of RTP that the centre opens for the legs of a call, and what happens where a terminal takes no part. */
class SpeechOverUdpTest {
    private static final MediaAddress CENTER = new MediaAddress("127.0.0.1", 20_000);
    private static final MediaAddress TERMINAL = new MediaAddress("127.0.0.1", 30_000);
    private static final byte[] SPEECH = new RtpPacket(RtpPacket.A_LAW, 1, 160, 7, new byte[160]).encode();

    private final TestNetwork network = new TestNetwork(new ExchangeSettings(
            "SimGSM",
            new SplittableRandom(1),
            Instant.parse("2026-11-21T12:00:00Z"),
            HomeRegister.OPEN,
            Optional.empty(),
            false,
            Locale.ENGLISH,
            true,
            NetworkTimer.T303.nanos(),
            Optional.empty(),
            HandoverAlgorithm.STANDARD));
    private final ActiveCallParts call = new ActiveCallParts();

    /** A call whose two terminals have a socket of their own in this test. */
    private final class ActiveCallParts {
        final TestMedia callerMedia = new TestMedia();
        final TestMedia calledMedia = new TestMedia();
        final ActiveCall active;

        ActiveCallParts() {
            network.mediaOf("5550100", callerMedia);
            network.mediaOf("5550200", calledMedia);
            active = network.activeCall("5550100", "5550200");
        }
    }

    /** A socket without a network. */
    static final class TestMedia implements MediaPort {
        final List<byte[]> sent = new ArrayList<>();
        boolean isOpen;
        Optional<MediaAddress> peer = Optional.empty();

        @Override
        public Optional<MediaAddress> openMedia() {
            isOpen = true;
            return Optional.of(CENTER);
        }

        @Override
        public boolean connectMedia(MediaAddress newPeer) {
            boolean isHere = newPeer.host().equals("127.0.0.1");
            peer = Optional.of(newPeer).filter(each -> isHere);
            return isHere;
        }

        @Override
        public boolean sendMedia(byte[] rtp) {
            sent.add(rtp);
            return true;
        }

        @Override
        public void closeMedia() {
            isOpen = false;
            peer = Optional.empty();
        }
    }

    private static MgcpMessage next(TestMobile mobile) throws ProtocolViolation {
        return MgcpMessage.decode(mobile.mgcp.remove(0));
    }

    private static void answer(TestMobile mobile, MgcpMessage answer) {
        mobile.frame(new IpaFrame(IpaFrame.MGCP, answer.encode()));
    }

    @Test
    void eachLegGetsASessionAndSpeechGoesBySocket() throws ProtocolViolation {
        MgcpMessage create = next(call.active.called());
        assertEquals(Head.CREATE_CONNECTION, create.head());
        assertEquals(Optional.of(CENTER), create.media());
        answer(call.active.called(), create.created("1", TERMINAL));
        assertEquals(Optional.of(TERMINAL), call.calledMedia.peer);

        call.active.caller().speak(SPEECH);

        assertEquals(1, call.calledMedia.sent.size());
        assertEquals(List.of(), call.active.called().heard);
    }

    @Test
    void theFirstSpeechWaitsForTheAnswer() throws ProtocolViolation {
        call.active.caller().speak(SPEECH);
        call.active.caller().speak(SPEECH);
        assertEquals(0, call.calledMedia.sent.size());

        answer(call.active.called(), next(call.active.called()).created("1", TERMINAL));

        assertEquals(2, call.calledMedia.sent.size());
        assertEquals(List.of(), call.active.called().heard);
    }

    @Test
    void speechWithoutAnAnswerFor200MsGoesWithTheSignalling() {
        IntStream.range(0, 10).forEach(frame -> call.active.caller().speak(SPEECH));
        assertEquals(List.of(), call.active.called().heard);

        IntStream.range(10, 25).forEach(frame -> {
            call.active.caller().speak(SPEECH);
            assertEquals(frame + 1, call.active.called().heard.size());
        });
    }

    @Test
    void afterARefusalSpeechGoesWithTheSignalling() throws ProtocolViolation {
        call.active.caller().speak(SPEECH);

        answer(call.active.called(), next(call.active.called()).answered(Head.NO_RESOURCES));
        assertTrue(!call.calledMedia.isOpen);
        assertEquals(1, call.active.called().heard.size());
        call.active.caller().speak(SPEECH);
        assertEquals(2, call.active.called().heard.size());
    }

    @Test
    void anAddressOnAnotherHostIsNotSpokenTo() throws ProtocolViolation {
        answer(call.active.called(), next(call.active.called()).created("1", new MediaAddress("192.0.2.1", 30_000)));

        call.active.caller().speak(SPEECH);

        assertTrue(!call.calledMedia.isOpen);
        assertEquals(1, call.active.called().heard.size());
    }

    @Test
    void theEndOfTheCallDeletesItsSessions() throws ProtocolViolation {
        answer(call.active.caller(), next(call.active.caller()).created("5", TERMINAL));
        call.active.caller().hangUp(TestMobile.OUR_CALL);

        MgcpMessage delete = next(call.active.caller());
        assertEquals(Head.DELETE_CONNECTION, delete.head());
        assertEquals(Optional.of("5"), delete.connection());
        assertTrue(!call.callerMedia.isOpen);
    }

    @Test
    void aSessionThatIsNotAnsweredYetIsDeletedByItsCall() throws ProtocolViolation {
        MgcpMessage create = next(call.active.caller());
        call.active.caller().hangUp(TestMobile.OUR_CALL);

        MgcpMessage delete = next(call.active.caller());
        assertEquals(Head.DELETE_CONNECTION, delete.head());
        assertEquals(create.call(), delete.call());
        assertEquals(Optional.empty(), delete.connection());
        answer(call.active.caller(), create.created("5", TERMINAL));
        assertTrue(!call.callerMedia.isOpen && call.callerMedia.peer.isEmpty());
    }

    @Test
    void theLossOfALinkClosesItsSession() {
        assertTrue(call.calledMedia.isOpen);
        call.active.called().vanish();

        assertTrue(!call.calledMedia.isOpen);
    }

    @Test
    void aRefusedCallHasNoSession() {
        TestMedia media = new TestMedia();
        network.mediaOf("5550101", media);
        TestMobile phone = network.attach("5550101");
        phone.dial("999");
        phone.next(CallControl.ReleaseComplete.class);

        assertTrue(!media.isOpen && phone.mgcp.isEmpty());
    }
}

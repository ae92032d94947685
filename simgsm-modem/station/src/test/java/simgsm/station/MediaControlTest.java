package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.IpaFrame;
import simgsm.abis.MgcpMessage;
import simgsm.abis.MgcpMessage.Head;
import simgsm.abis.MgcpMessage.MediaAddress;
import simgsm.air.ProtocolViolation;
import simgsm.station.context.MobileRadioConnection;
import simgsm.station.context.StationContext;
import simgsm.station.context.Uplink;

/** What a station answers to the centre that asks for speech over UDP. */
class MediaControlTest {
    private static final MediaAddress CENTER = new MediaAddress("127.0.0.1", 20_000);
    private static final MediaAddress OWN = new MediaAddress("127.0.0.1", 30_000);

    private final Scene scene = Scene.registered();

    private MgcpMessage answer(MgcpMessage command) throws ProtocolViolation {
        scene.frame(IpaFrame.MGCP, command.encode());
        return MgcpMessage.decode(scene.mgcp.remove(0));
    }

    @Test
    void aSocketIsOpenedTowardsTheCentreAndItsAddressSent() throws ProtocolViolation {
        scene.ownMedia = Optional.of(OWN);
        MgcpMessage answer = answer(MgcpMessage.create(7, "1", CENTER));

        assertEquals(Head.OK, answer.head());
        assertEquals(7, answer.transaction());
        assertEquals(Optional.of(OWN), answer.media());
        assertEquals(Optional.of(CENTER), scene.mediaPeer);

        assertEquals(Head.DELETED, answer(MgcpMessage.delete(8, "1", "1")).head());
        assertEquals(Optional.empty(), scene.mediaPeer);
    }

    @Test
    void speechThatIsLateForTheEndedSocketDoesNotGoWithTheSignalling() {
        List<IpaFrame> sent = new ArrayList<>();
        Uplink uplink = new Uplink() {
            @Override
            public void send(IpaFrame frame) {
                sent.add(frame);
            }

            @Override
            public void drop() {
                // Not here.
            }
        };
        MobileRadioConnection radio =
                StationContext.of(scene.identity, event -> {}, () -> {}).radio();
        radio.setUplink(uplink);
        radio.send(IpaFrame.SPEECH, new byte[] {1});
        assertEquals(1, sent.size(), "without media speech goes with the signalling");
        radio.closeMedia();
        radio.send(IpaFrame.SPEECH, new byte[] {2});
        assertEquals(1, sent.size(), "late speech");
        radio.openMedia(CENTER);
        radio.send(IpaFrame.SPEECH, new byte[] {3});
        assertEquals(2, sent.size(), "the next call's");
    }

    @Test
    void withoutASocketTheAnswerIsARefusal() throws ProtocolViolation {
        assertEquals(
                Head.NO_RESOURCES, answer(MgcpMessage.create(7, "1", CENTER)).head());
    }

    @Test
    void anAnswerIsNotAnswered() {
        scene.frame(
                IpaFrame.MGCP,
                MgcpMessage.create(7, "1", CENTER).answered(Head.OK).encode());

        assertEquals(0, scene.mgcp.size());
    }

    @Test
    void anUnreadableMessageIsDropped() {
        scene.frame(IpaFrame.MGCP, new byte[] {1, 2, 3});

        assertEquals(0, scene.mgcp.size());
    }
}

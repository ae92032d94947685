package simgsm.center.msc;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.CcmCodec;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.air.MobilityManagement;
import simgsm.air.RadioResource;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.center.msc.link.TerminalAccess;

/** An error of the centre's own ends the link that it belongs to, and no other. */
class OwnErrorTest {
    private static final Duration UNTIL_THE_FIRST_PING = Duration.ofSeconds(30);

    private static final byte[] PING = CcmCodec.encode(new CcmMessage.Ping());

    private final TestNetwork network = new TestNetwork();
    private Optional<String> closedFor = Optional.empty();

    /** A link on which the ping, which a timer sends, meets an error. */
    private void openLinkWithAnError() {
        LinkPort port = new LinkPort() {
            @Override
            public void send(IpaFrame frame) {
                if (frame.stream() == IpaFrame.CCM && Arrays.equals(PING, frame.payload())) {
                    throw new IllegalStateException("a made-up error of our own");
                }
            }

            @Override
            public void close(String reason) {
                closedFor = Optional.of(reason);
            }
        };
        Peer link = network.exchange.linkOpened(network.nowNanos, port, "one with an error");
        byte[] identity = CcmCodec.encode(new CcmMessage.IdentityResponse("phone", "490154203237518"));
        network.exchange.frameReceived(network.nowNanos, link, new IpaFrame(IpaFrame.CCM, identity));
    }

    @Test
    void anErrorInATimerClosesItsOwnLinkAndTheFrameOfAnotherLinkIsServed() {
        openLinkWithAnError();
        network.nowNanos += UNTIL_THE_FIRST_PING.toNanos() * 2 / 3;
        TestMobile other = network.connect("5550100");
        network.nowNanos += UNTIL_THE_FIRST_PING.toNanos() / 3;
        other.register();
        assertEquals(Optional.of("internal error"), closedFor);
        assertEquals(Optional.empty(), other.closedFor);
        assertEquals(
                "5550100",
                TerminalAccess.linkOf(other.link).subscriber().number().digits());
        assertEquals(1, network.exchange.linkCount());
    }

    @Test
    void anErrorInATimerDoesNotKeepTheOtherTimersFromRunning() {
        openLinkWithAnError();
        openLinkWithAnError();
        TestMobile other = network.connect("5550100");
        network.leap(UNTIL_THE_FIRST_PING);
        assertEquals(0, network.exchange.linkCount());
        assertEquals(Optional.of("has not identified itself"), other.closedFor);
    }

    @Test
    void anErrorWhileAnUnusedChannelIsReleasedClosesThatLinkOnly() {
        TestMobile wrong = network.attach("5550100");
        TestMobile other = network.connect("5550200");
        wrong.failsOn = RadioResource.ChannelRelease.class;
        wrong.requestService(MobilityManagement.ServiceType.MOBILE_ORIGINATED_CALL);
        network.nowNanos += Duration.ofSeconds(10).toNanos();
        other.register();
        assertEquals(Optional.of("internal error"), wrong.closedFor);
        assertEquals(Optional.empty(), other.closedFor);
    }
}

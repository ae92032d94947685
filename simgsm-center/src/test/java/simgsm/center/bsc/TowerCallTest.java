package simgsm.center.bsc;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.abis.RslElement;
import simgsm.abis.RslType;
import simgsm.center.msc.call.CallProgress;

/** Calls over towers: assignment, speech, handover, congestion, loss; octets as osmo-bsc 1.9 has them. */
class TowerCallTest extends TowerCalls {
    @Test
    void aCallGetsItsTrafficChannelByAssignment() {
        String channel = dial(west);
        west.down(
                "0821 0109 0301 0604 00010801 0506 64094064 7200 0400 0d0e 1800 1f00",
                "0301 01" + channel + "0200 0b0002 8302",
                "0c15 0190 0e00 0c05 f4" + called + "2800");
        west.up("0822 0109 08 0000");
        west.down("0301 01" + channel + "0200 0b0008 062e0940640e6301", "7e70 0109 f410 f203");
        west.up("7e71 0109 f80001 f57f000001 f34e20");
        west.down("7e73 0109 f80001 f07f000001 f14e20 f400 f203");
        west.up("7e74 0109 f80001");
        west.up("0206 0109 0200");
        west.up("0302 0109 0200 0b0003 062900");
        west.down("0825 01" + channel);
        stage.passMillis(2_000);
        west.down("082e 01" + channel);
    }

    @Test
    void speechPassesBetweenTheTowersUnchangedAndTheCallEndsInOrder() {
        String[] channels = activeCall();

        west.media.get(0).speak(rtp(1));
        east.media.get(0).speak(rtp(9));

        assertArrayEquals(rtp(1), east.media.get(0).heard.get(0));
        assertArrayEquals(rtp(9), west.media.get(0).heard.get(0));
        west.tell(channels[0], "0365 02e090");
        assertEquals("832d", west.nextLayer3().substring(0, 4));
        west.tell(channels[0], "032a");
        assertEquals("060d00", west.nextLayer3());
        west.leave(channels[0]);
        assertFalse(west.media.get(0).isOpen);
        assertEquals(CallProgress.RELEASED, progress());
    }

    @Test
    void aSignallingTrafficChannelBecomesTheSpeechChannelByModeModify() {
        String channel = dialOnATrafficChannel();
        west.down(
                "0301 01" + channel + "0200 0b0006 0610" + channel + "406401",
                "0301 01" + channel + "0200 0b0002 8302");
        west.next(RslType.PAGING_COMMAND);
        west.tell(channel, "0617" + channel + "406401");
        west.down("0829 01" + channel + "0604 00010801");
        west.up("082a 01" + channel);
        west.down("7e70 01" + channel + "f410 f203");
        west.up("7e71 01" + channel + "f80001 f57f000001 f34e20");
        west.next(RslType.MODIFY_CONNECTION);

        String calledChannel = answer();
        assertTrue(calledChannel.startsWith("0"));
        west.tell(channel, "030f");
        assertEquals(CallProgress.ACTIVE, progress());
        east.media.get(0).speak(rtp(1));
        assertArrayEquals(rtp(1), west.media.get(0).heard.get(0));
    }

    @ParameterizedTest
    @CsvSource({"0302 01%s0200 0b0006 0617%s406400, 0", "082b 01%s 1a0101, 0", "'', 5000"})
    void aSignallingTrafficChannelWhoseModeIsNotChangedEndsTheCallWithCause34(String refusal, int millis) {
        String channel = dialOnATrafficChannel();
        if (refusal.startsWith("082b")) {
            west.tell(channel, "0617" + channel + "406401");
        }
        west.received.clear();
        if (!refusal.isEmpty()) {
            west.up(String.format(refusal, channel, channel));
        }
        stage.passMillis(millis);

        assertEquals("832502e2a2", lastLayer3());
    }

    @Test
    void aTowerThatChangesTheModeTooLateIsAskedAgainForTheNextCall() {
        String channel = dialOnATrafficChannel();
        west.tell(channel, "0617" + channel + "406401");
        stage.passMillis(5_000);
        west.up("082a 01" + channel);
        west.tell(channel, "0524 71 03331981 05f4" + caller);
        west.tell(channel, "036d");
        west.received.clear();

        west.tell(channel, "1305 0406600402000581 5e0581550502f0");

        assertTrue(
                west.received.stream().anyMatch(message -> message.toString().contains("0610" + channel + "406401")),
                west.received.toString());
    }

    private String lastLayer3() {
        String last = "";
        while (west.received.stream().anyMatch(message -> message.toString().startsWith("0301"))) {
            last = west.nextLayer3();
        }
        return last;
    }

    /** A call of a mobile that got a traffic channel, because all signalling channels are in use. */
    private String dialOnATrafficChannel() {
        for (int i = 0; i < 4; i++) {
            west.up("0c13 0188 13 05 1234 1100");
        }
        String channel = dial(west);
        assertEquals("09", channel);
        return channel;
    }

    @Test
    void layer3WaitsWhileAnAssignmentRuns() {
        dial(west);
        west.up("0822 0109 08 0000");
        answer();
        west.received.clear();

        west.up("0206 0109 0200");
        west.quiet();
        west.up("0302 0109 0200 0b0003 062900");

        assertEquals("8301", west.nextLayer3());
        assertTrue(west.nextLayer3().startsWith("8307"));
    }

    @Test
    void aMobileThatComesBackFromAnAssignmentLosesItsCallWithCause34() {
        String signalling = dial(west);
        west.up("0822 0109 08 0000");
        west.received.clear();

        west.tell(signalling, "062f6f");

        west.down("0825 0109", "082e 0109");
        assertEquals("832502e2a2", west.nextLayer3());
    }

    @Test
    void withoutAFreeTrafficChannelACallWaits5SecondsAndEndsWithCause34() {
        occupyTrafficChannels();
        String signalling = dial(west);
        west.down("0301 01" + signalling + "0200 0b0002 8302");
        stage.passMillis(4_999);
        while (!west.received.isEmpty()) {
            assertTrue(west.received.remove().toString().startsWith("0c"), "only common channels meanwhile");
        }
        stage.passMillis(1);

        assertEquals("832502e2a2", west.nextLayer3());
    }

    @Test
    void theNextCallWaitsForAChannelAlthoughTheMobileHasNotReleasedTheOneThatGotNone() {
        List<String> occupied = occupyTrafficChannels();
        String signalling = dial(west);
        stage.passMillis(5_000);
        assertEquals("832502e2a2", lastLayer3());
        west.tell(signalling, "0524 71 03331981 05f4" + caller);
        west.tell(signalling, "1345 0406600402000581 5e0581550502f0");
        west.received.clear();

        west.up("0823 01" + occupied.get(0) + "1a0100");
        west.up("0833 01" + occupied.get(0));

        assertEquals(occupied.get(0), TestTower.channelOf(west.next(RslType.CHANNEL_ACTIVATION)));
    }

    @Test
    void aCallThatWaitsGetsTheTrafficChannelThatBecomesFree() {
        List<String> occupied = occupyTrafficChannels();
        dial(west);
        stage.passMillis(2_000);
        west.received.clear();

        west.up("0823 01" + occupied.get(0) + "1a0100");
        west.up("0833 01" + occupied.get(0));

        assertEquals(occupied.get(0), TestTower.channelOf(west.next(RslType.CHANNEL_ACTIVATION)));
    }

    @Test
    void aCallThatWaitsIsHandedOverToANeighbourWithAFreeTrafficChannel() {
        occupyTrafficChannels();
        String signalling = dial(west);
        west.received.clear();
        east.received.clear();
        measure(west, signalling, 0, 50, 19);
        east.quiet();

        measure(west, signalling, 1, 50, 20);

        assertEquals(
                "02",
                east.next(RslType.CHANNEL_ACTIVATION)
                        .find(RslElement.ACTIVATION_TYPE)
                        .orElseThrow()
                        .toString());
        east.up("0822 0109 08 0000");
        assertEquals("062b0b6e09606e", west.nextLayer3().substring(0, 14));
        east.up("0827 0109 1100");
        east.tell("09", "062c00");
        west.down("0825 01" + signalling);
        assertEquals(CallProgress.INITIATED, progress());
    }

    @Test
    void aCallIsHandedOverToTheBetterCellAndGoesOnThere() {
        String[] channels = activeCall();
        for (int number = 0; number < 17; number++) {
            measure(west, channels[0], number, 50 - 2 * number, 15 + 2 * number);
        }
        west.quiet();
        east.quiet();

        measure(west, channels[0], 17, 16, 49);

        east.down("0821 010a 0302 0604 00010801 0506 640a606e 7200 0901 0400 0d0e 1f00");
        east.up("0822 010a 08 0000");
        west.down("0301 01" + channels[0] + "0200 0b000b 062b0b6e0a606e010e6301");
        east.down("7e70 010a f410 f203");
        east.up("7e71 010a f80001 f57f000001 f34e22");
        east.next(RslType.MODIFY_CONNECTION);
        // Until the mobile is detected, it may be in either cell.
        east.media.get(0).speak(rtp(1));
        assertEquals(1, west.media.get(0).heard.size());
        assertArrayEquals(rtp(1), east.media.get(1).heard.get(0));
        east.up("0827 010a 1100");
        east.media.get(0).speak(rtp(2));
        assertEquals(1, west.media.get(0).heard.size());
        assertArrayEquals(rtp(2), east.media.get(1).heard.get(1));
        east.up("0206 010a 0200");
        east.up("0302 010a 0200 0b0003 062c00");
        west.down("0825 01" + channels[0]);
        east.media.get(1).speak(rtp(3));
        assertEquals(1, east.media.get(0).heard.size());

        stage.passMillis(2_000);
        west.down("082e 01" + channels[0]);
        east.tell("0a", "0365 02e090");
        assertEquals("832d", east.nextLayer3().substring(0, 4));
    }

    @Test
    void aMobileThatComesBackFromAHandoverKeepsItsOldChannel() {
        String[] channels = activeCall();
        measure(west, channels[0], 5, 20, 40);
        east.up("0822 010a 08 0000");
        west.received.clear();
        east.received.clear();

        west.tell(channels[0], "06286f");

        east.down("0825 010a", "082e 010a");
        west.quiet();
        east.media.get(0).speak(rtp(1));
        assertEquals(1, west.media.get(0).heard.size());
        assertEquals(CallProgress.ACTIVE, progress());
    }

    @Test
    void aMobileThatIsLostInAHandoverIsClearedAfterT3103() {
        String[] channels = activeCall();
        measure(west, channels[0], 5, 20, 40);
        east.up("0822 010a 08 0000");
        stage.passMillis(4_999);
        assertEquals(CallProgress.ACTIVE, progress());

        stage.passMillis(1);

        assertEquals(CallProgress.RELEASED, progress());
    }

    @Test
    void aTowerThatIsKilledInMidCallEndsTheCallOfItsMobile() {
        String[] channels = activeCall();

        west.vanish();

        assertEquals(CallProgress.RELEASED, progress());
        assertEquals("032502e2a9", east.nextLayer3());
        assertTrue(channels[1].startsWith("0"));
        assertFalse(west.media.get(0).isOpen);
    }

    @Test
    void aRadioLinkFailureEndsTheCall() {
        String[] channels = activeCall();

        west.up("0824 01" + channels[0] + "1a0101");

        west.down("0825 01" + channels[0], "082e 01" + channels[0]);
        assertEquals(CallProgress.RELEASED, progress());
    }
}

package simgsm.center.bsc;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import simgsm.abis.RslType;
import simgsm.abis.RtpPacket;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.call.CallProgress;

/** Two towers with a registered mobile in each, and calls between the two. */
abstract class TowerCalls {
    final TowerStage stage = new TowerStage();
    TestTower west;
    TestTower east;
    String caller;
    String called;

    @BeforeEach
    void register() {
        west = stage.west();
        east = stage.east();
        caller = west.register("5550100", TowerStage.IMEI);
        called = east.register("5550200", TowerStage.OTHER_IMEI);
    }

    static final String SETUP = "0345 0406600402000581 5e0581550502f0";

    /** Up to SETUP on the SDCCH. */
    String dial(TestTower tower) {
        String channel = tower.access("e1", "0524 71 03331981 05f4" + caller);
        assertEquals("0521", tower.nextLayer3());
        tower.received.clear();
        tower.tell(channel, SETUP);
        return channel;
    }

    /** The called mobile answers paging and SETUP. @return its traffic channel */
    String answer() {
        east.next(RslType.PAGING_COMMAND);
        String channel = east.access("91", "0627 07 03331981 05f4" + called);
        assertEquals("0305", east.nextLayer3().substring(0, 4));
        east.tell(channel, "8308");
        String traffic = east.followAssignment(channel);
        east.tell(traffic, "8341");
        east.tell(traffic, "8307");
        return traffic;
    }

    String[] activeCall() {
        String signalling = dial(west);
        String callerChannel = west.followAssignment(signalling);
        String calledChannel = answer();
        west.tell(callerChannel, "030f");
        assertEquals(CallProgress.ACTIVE, progress());
        stage.passMillis(2_000);
        west.up("0833 01" + signalling);
        west.received.clear();
        east.received.clear();
        return new String[] {callerChannel, calledChannel};
    }

    CallProgress progress() {
        List<CallProgress> states = new ArrayList<>();
        for (ExchangeEvent event : stage.events) {
            if (event instanceof ExchangeEvent.CallChanged changed) {
                states.add(changed.state());
            }
        }
        return states.get(states.size() - 1);
    }

    static byte[] rtp(int sequence) {
        return new RtpPacket(RtpPacket.A_LAW, sequence, 160L * sequence, 7, new byte[160]).encode();
    }

    /** A measurement result without bad bursts and with one neighbour: frequency index 0, BSIC 11. */
    static void measure(TestTower tower, String channel, int number, int level, int neighbour) {
        String serving = String.format("%02x%02x", level, level);
        String one = String.format("%02x", 0x40 | neighbour) + "0160";
        tower.up("0828 01" + channel + "1b" + String.format("%02x", number) + "1903" + serving
                + "00 0400 0a0000 0b0012 0615" + serving + "00" + one + "00".repeat(10));
    }

    /** Channel requests without a mobile: four take the SDCCHs, seven the traffic channels, which are never activated. */
    List<String> occupyTrafficChannels() {
        stage.passMillis(10_000);
        for (int i = 0; i < 3; i++) {
            west.up("0c13 0188 13 05 1234 1100");
        }
        List<String> channels = new ArrayList<>();
        String last = null;
        west.received.clear();
        for (int i = 0; i < 8; i++) {
            west.up("0c13 0188 13 05 1234 1100");
            String channel = TestTower.channelOf(west.next(RslType.CHANNEL_ACTIVATION));
            if (i == 0) {
                last = channel;
            } else {
                channels.add(channel);
            }
        }
        west.received.clear();
        west.up("0c13 0188 13 05 1234 1100");
        west.down("0c16 0190 2b17 4d063a03 0512340a 0512340a 0512340a 0512340a 2b2b2b");
        // One SDCCH comes back.
        west.up("0823 01" + last + "1a0100");
        west.up("0833 01" + last);
        west.received.clear();
        return channels;
    }
}

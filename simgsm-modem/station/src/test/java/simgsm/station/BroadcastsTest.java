package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.abis.RslMessage;
import simgsm.sms.BroadcastSerial;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;
import simgsm.sms.ChannelList;

/** Cell broadcast at a station. */
class BroadcastsTest extends MessageStage {
    @Test
    void aBroadcastIsShownOnceHoweverOftenItsPagesCome() {
        String text = "Fire drill at noon. ".repeat(7);
        List<CellBroadcastPage> pages =
                CellBroadcast.split(text, 50, BroadcastSerial.ofValue(0x4011), Optional.empty());
        for (int round = 0; round < 2; round++) {
            pages.forEach(page -> scene.rsl(new RslMessage.SmsBroadcastCommand(page.encode())));
        }
        assertEquals(List.of("broadcast 50 in 2: " + text), scene.reported.lines());
    }

    @Test
    void aPhoneThatIsOffShowsNoBroadcast() {
        scene.station.powerOff();
        scene.reported.clear();
        CellBroadcast.split("x", 50, BroadcastSerial.ofValue(0x4011), Optional.empty())
                .forEach(page -> scene.rsl(new RslMessage.SmsBroadcastCommand(page.encode())));
        assertEquals(List.of(), scene.reported.lines());
    }

    private void broadcast(int channel, int serial, String text) {
        CellBroadcast.split(text, channel, BroadcastSerial.ofValue(serial), Optional.empty())
                .forEach(page -> scene.rsl(new RslMessage.SmsBroadcastCommand(page.encode())));
    }

    @Test
    void onlyWantedChannelsAreShown() {
        scene.station.setChannels(ChannelList.parse("50,900-999"));
        broadcast(50, 0x4011, "area");
        broadcast(51, 0x4011, "unwanted");
        broadcast(919, 0x4011, "warning");
        assertEquals(List.of("broadcast 50 in 1: area", "broadcast 919 in 1: warning"), scene.reported.lines());
    }

    @Test
    void whatWasDiscardedIsShownOnceItIsWantedAndRepeated() {
        scene.station.setChannels(ChannelList.NONE);
        broadcast(50, 0x4011, "again and again");
        assertEquals(List.of(), scene.reported.lines());
        scene.station.setChannels(ChannelList.ALL);
        broadcast(50, 0x4011, "again and again");
        broadcast(50, 0x4011, "again and again");
        assertEquals(List.of("broadcast 50 in 1: again and again"), scene.reported.lines());
    }

    @Test
    void anUpdateIsShownAndARepetitionOverANewLinkIsNot() {
        broadcast(50, 0x4010, "12 degrees");
        scene.linkDown();
        scene.linkUp();
        scene.identify();
        scene.acceptLocationUpdating();
        scene.reported.clear();
        broadcast(50, 0x4010, "12 degrees");
        assertEquals(List.of(), scene.reported.lines());
        broadcast(50, 0x4011, "13 degrees");
        assertEquals(List.of("broadcast 50 in 1: 13 degrees"), scene.reported.lines());
    }
}

package simgsm.center.msc;

import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import simgsm.air.RslMessage;
import simgsm.sms.BroadcastSerial;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;

/** Cell broadcast (TS 23.041): the same pages to everybody who is attached. */
final class Broadcaster {
    private static final int CODES = 1024;

    private final Mobility mobility;
    private int nextCode;

    /** @param random for the first message code, so that phones do not take a new centre's broadcasts for old ones */
    Broadcaster(Mobility mobility, RandomGenerator random) {
        this.mobility = mobility;
        this.nextCode = random.nextInt(CODES);
    }

    /**
     * @param channel message identifier, 0 to 65535
     * @return the number of pages
     */
    int broadcast(int channel, String text) {
        BroadcastSerial serial = new BroadcastSerial(BroadcastSerial.NETWORK_WIDE, nextCode, 0);
        List<CellBroadcastPage> pages = CellBroadcast.split(text, channel, serial, Optional.empty());
        nextCode = (nextCode + 1) % CODES;
        for (Link link : mobility.attachedLinks()) {
            for (CellBroadcastPage page : pages) {
                link.sendCommon(new RslMessage.SmsBroadcastCommand(page.encode()));
            }
        }
        return pages.size();
    }
}

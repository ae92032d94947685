package blackbox;

import static org.junit.jupiter.api.Assertions.fail;

import java.util.Queue;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import simgsm.abis.IpaFrame;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.station.MobileStation;
import simgsm.station.context.Uplink;

/** One station's connection to the exchange without a socket; it can be made to lose what the station sends. */
final class VirtualLink {
    final MobileStation station;
    private final Supplier<Exchange> exchange;
    private final SuiteTrace trace;
    private final Queue<Runnable> underWay;
    private final LongSupplier clockNanos;
    private boolean losesSpeech;
    private boolean losesAll;
    private Peer atExchange;

    VirtualLink(
            MobileStation station,
            Supplier<Exchange> exchange,
            Queue<Runnable> underWay,
            LongSupplier clockNanos,
            SuiteTrace trace) {
        this.trace = trace;
        this.station = station;
        this.exchange = exchange;
        this.underWay = underWay;
        this.clockNanos = clockNanos;
    }

    void up() {
        atExchange = exchange.get().linkOpened(clockNanos.getAsLong(), new Down(), "memory");
        station.linkUp(new Up(), clockNanos.getAsLong());
    }

    /** The connection breaks. */
    void down() {
        station.linkDown(clockNanos.getAsLong());
    }

    private String number() {
        return station.identity().number().toString();
    }

    /** From here on nothing of what the station says in a call arrives. */
    void loseSpeech() {
        losesSpeech = true;
    }

    /** From here on nothing of what the station sends arrives, though the connection stands. */
    void loseAll() {
        losesAll = true;
    }

    private final class Up implements Uplink {
        @Override
        public void send(IpaFrame frame) {
            trace.frame(number(), true, frame);
            if (!losesAll && !(losesSpeech && frame.stream() == IpaFrame.SPEECH)) {
                underWay.add(() -> exchange.get().frameReceived(clockNanos.getAsLong(), atExchange, frame));
            }
        }

        @Override
        public void drop() {
            fail(station.identity().number() + " dropped its link");
        }
    }

    private final class Down implements LinkPort {
        @Override
        public void send(IpaFrame frame) {
            trace.frame(number(), false, frame);
            underWay.add(() -> station.frameArrived(frame, clockNanos.getAsLong()));
        }

        @Override
        public void close(String reason) {
            fail("the exchange closed the link of " + station.identity().number() + ": " + reason);
        }
    }
}

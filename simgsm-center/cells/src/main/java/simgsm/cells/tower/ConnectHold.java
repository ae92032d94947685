package simgsm.cells.tower;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.octets.OctetString;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Holds a mobile's CONNECT, and the connection management messages after it, until 100 ms after the channel's first
 * modified speech connection: osmo-msc 1.9 clears a call with cause 6 that is answered before it knows the speech codec.
 */
final class ConnectHold {
    static final long SETTLING_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
    /** Maximum hold, for a controller that assigns the channel only after CONNECT. */
    static final long LIMIT_NANOS = TimeUnit.SECONDS.toNanos(1);

    private static final int RADIO_RESOURCE = 0x06;
    private static final int CALL_CONTROL = 0x03;
    private static final int CONNECT = 0x07;

    private final Timers timers;
    private final Consumer<OctetString> output;
    private final List<OctetString> held = new ArrayList<>();
    /** Null until speech is connected or a message is held. */
    private Timer timer;

    private boolean isSpeechConnected;
    private boolean isOver;

    ConnectHold(Timers timers, Consumer<OctetString> output) {
        this.timers = timers;
        this.output = output;
    }

    /** Sends a message of the main link, now or later. */
    void send(OctetString layer3) {
        int discriminator = layer3.octet(0) & 0x0f;
        boolean isConnect = discriminator == CALL_CONTROL && layer3.length() > 1 && (layer3.octet(1) & 0x3f) == CONNECT;
        if (isOver || (held.isEmpty() ? !isConnect : discriminator == RADIO_RESOURCE)) {
            output.accept(layer3);
            return;
        }
        if (timer == null) {
            timer = timers.start(LIMIT_NANOS, this::end);
        }
        held.add(layer3);
    }

    /** The speech connection was modified. */
    void speechConnected() {
        if (!isSpeechConnected) {
            isSpeechConnected = true;
            timers.cancel(timer);
            timer = timers.start(SETTLING_NANOS, this::end);
        }
    }

    private void end() {
        isOver = true;
        drain().forEach(output);
    }

    /**
     * Ends the hold.
     *
     * @return the held messages
     */
    List<OctetString> drain() {
        timers.cancel(timer);
        List<OctetString> all = List.copyOf(held);
        held.clear();
        return all;
    }
}

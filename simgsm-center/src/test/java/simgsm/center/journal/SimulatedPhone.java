package simgsm.center.journal;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import simgsm.air.Imei;
import simgsm.air.IpaFrame;
import simgsm.air.Msisdn;
import simgsm.air.RpCause;
import simgsm.center.msc.Link;
import simgsm.center.msc.LinkPort;
import simgsm.station.MobileStation;
import simgsm.station.Sim;
import simgsm.station.SpeechSource;
import simgsm.station.StationIdentity;
import simgsm.station.StationListener;
import simgsm.station.StationOptions;
import simgsm.station.Uplink;

/** A real station core whose frames travel when chance says so, in order. */
final class SimulatedPhone implements StationListener {
    final Msisdn number;
    final MobileStation station;
    final Deque<IpaFrame> up = new ArrayDeque<>();
    final Deque<IpaFrame> down = new ArrayDeque<>();
    /** How often each text was shown, whichever phone showed it. */
    private final Map<String, Integer> shown;
    /** What the network has acknowledged. */
    private final Set<String> acknowledged;

    private final Map<Integer, String> sending = new HashMap<>();
    /** Null while there is no connection. */
    Link link;

    boolean isDropped;

    SimulatedPhone(String digits, SplittableRandom random, Map<String, Integer> shown, Set<String> acknowledged) {
        this.number = new Msisdn(digits);
        this.shown = shown;
        this.acknowledged = acknowledged;
        station = new MobileStation(
                StationIdentity.ofOpenNumber(number, Imei.random(random), "simulated"),
                Sim.WITHOUT_KEY,
                StationOptions.STANDARD,
                SpeechSource.SILENCE,
                this,
                random);
    }

    void write(Msisdn to, String text) {
        // Within one turn of the references no message stays under way.
        sending.put(station.sendMessage(to, text), text);
    }

    boolean isConnected() {
        return link != null;
    }

    /** The connection is gone on this side. */
    void disconnected(long nowNanos) {
        link = null;
        isDropped = false;
        up.clear();
        down.clear();
        station.linkDown(nowNanos);
    }

    Uplink uplink() {
        return new Uplink() {
            @Override
            public void send(IpaFrame frame) {
                up.add(frame);
            }

            @Override
            public void drop() {
                isDropped = true;
            }
        };
    }

    LinkPort downlink() {
        return new LinkPort() {
            @Override
            public void send(IpaFrame frame) {
                down.add(frame);
            }

            @Override
            public void close(String reason) {
                isDropped = true;
            }
        };
    }

    @Override
    public void messageReceived(String from, String text) {
        shown.merge(text, 1, Integer::sum);
    }

    @Override
    public void messageSent(int id, Msisdn to, int parts) {
        Optional.ofNullable(sending.get(id)).ifPresent(acknowledged::add);
    }

    @Override
    public void messageFailed(int id, Msisdn to, RpCause cause) {
        sending.remove(id);
    }
}

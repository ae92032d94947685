package simgsm.center.journal;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.sim.SimCard;
import simgsm.station.MobileStation;
import simgsm.station.StationOptions;
import simgsm.station.call.SpeechSource;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationIdentity;
import simgsm.station.context.Uplink;
import simgsm.station.mobility.Sim;

/** A real station core whose frames travel when chance says so, in order. */
final class SimulatedPhone {
    final Msisdn number;
    final MobileStation station;
    private final Account account;
    /** By id, what is not yet acknowledged. */
    private final Map<Integer, Account.Key> sending = new HashMap<>();

    private final Set<String> broadcasts = new HashSet<>();
    /** Null while there is no connection. */
    Wire wire;

    /** One connection, which may outlive its use on either side. */
    static final class Wire implements Uplink {
        final Deque<IpaFrame> up = new ArrayDeque<>();
        final Deque<IpaFrame> down = new ArrayDeque<>();
        /** What sees the frames that go down. */
        private final Consumer<IpaFrame> watch;

        Peer link;
        boolean isDropped;

        Wire(Consumer<IpaFrame> watch) {
            this.watch = watch;
        }

        boolean isIdle() {
            return up.isEmpty() && down.isEmpty();
        }

        @Override
        public void send(IpaFrame frame) {
            up.add(frame);
        }

        @Override
        public void drop() {
            isDropped = true;
        }

        LinkPort downlink() {
            return new LinkPort() {
                @Override
                public void send(IpaFrame frame) {
                    watch.accept(frame);
                    down.add(frame);
                }

                @Override
                public void close(String reason) {
                    isDropped = true;
                }
            };
        }
    }

    SimulatedPhone(SimCard card, Sim sim, SplittableRandom random, Account account) {
        this.number = card.number();
        this.account = account;
        station = new MobileStation(
                StationIdentity.ofCard(card, Imei.random(random), "simulated"),
                sim,
                StationOptions.STANDARD,
                SpeechSource.SILENCE,
                this::accept,
                random);
    }

    private void accept(StationEvent event) {
        if (event instanceof StationEvent.StationUnregistered) {
            // A refusal may be temporary; that of a card would not be.
            Invariant.holds(!station.snapshot().cardRefused(), () -> number + " has its card refused");
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            account.shown(new Account.Key(message.from(), number.digits(), message.text()));
        } else if (event instanceof StationEvent.MessageSent sent) {
            account.acknowledged(sending.remove(sent.id()));
        } else if (event instanceof StationEvent.MessageFailed failed) {
            sending.remove(failed.id());
        } else if (event instanceof StationEvent.BroadcastReceived broadcast) {
            String text = broadcast.text();
            Invariant.holds(broadcasts.add(text), () -> "broadcast \"" + text + "\" is shown twice");
        }
    }

    void write(Msisdn to, String text) {
        if (station.snapshot().powered()) {
            Account.Key key = new Account.Key(number.digits(), to.digits(), text);
            account.written(key);
            sending.put(station.sendMessage(to, text), key);
        }
    }

    boolean isConnected() {
        return wire != null;
    }

    /** The connection is gone on this side. */
    void disconnected(long nowNanos) {
        wire = null;
        station.linkDown(nowNanos);
    }
}

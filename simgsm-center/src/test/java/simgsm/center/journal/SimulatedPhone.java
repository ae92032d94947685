package simgsm.center.journal;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import simgsm.abis.IpaFrame;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.air.RejectCause;
import simgsm.air.RpCause;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.LinkPort;
import simgsm.sim.SimCard;
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
    private final Account account;
    /** Under each message reference, oldest first, what is not yet acknowledged. */
    private final Map<Integer, Deque<Account.Key>> sending = new HashMap<>();

    private final Set<String> broadcasts = new HashSet<>();
    /** Null while there is no connection. */
    Wire wire;

    /** One connection, which may outlive its use on either side. */
    static final class Wire implements Uplink {
        final Deque<IpaFrame> up = new ArrayDeque<>();
        final Deque<IpaFrame> down = new ArrayDeque<>();
        /** What sees the frames that go down. */
        private final Consumer<IpaFrame> watch;

        Link link;
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
                this,
                random);
    }

    /** A refusal may pass; that of a card would not. */
    @Override
    public void unregistered(Optional<RejectCause> cause) {
        Invariant.holds(!station.snapshot().cardRefused(), () -> number + " has its card refused");
    }

    void write(Msisdn to, String text) {
        if (station.snapshot().powered()) {
            Account.Key key = new Account.Key(number.digits(), to.digits(), text);
            account.written(key);
            sending.computeIfAbsent(station.sendMessage(to, text), id -> new ArrayDeque<>())
                    .add(key);
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

    @Override
    public void messageReceived(String from, String text) {
        account.shown(new Account.Key(from, number.digits(), text));
    }

    @Override
    public void messageSent(int id, Msisdn to, int parts) {
        account.acknowledged(sending.get(id).remove());
    }

    @Override
    public void messageFailed(int id, Msisdn to, RpCause cause) {
        sending.get(id).remove();
    }

    @Override
    public void broadcastReceived(int channel, int pages, String text) {
        Invariant.holds(broadcasts.add(text), () -> "broadcast \"" + text + "\" is shown twice");
    }
}

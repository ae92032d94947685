package simgsm.center.msc;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.random.RandomGenerator;
import simgsm.center.msc.link.BroadcastChannel;
import simgsm.center.msc.mobility.MobilityProcedures;
import simgsm.sms.BroadcastSerial;
import simgsm.sms.CellBroadcast;
import simgsm.sms.CellBroadcastPage;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * Cell broadcast (TS 23.041): sends the same pages to all attached terminals, once or repeatedly for those that attach later;
 * a phone shows a serial number once.
 */
final class Broadcaster {
    /** Maximum of repeated broadcasts. */
    static final int MOST_RUNNING = 100;

    private static final int CODES = 1024;
    private static final int UPDATES = 16;

    private final MobilityProcedures mobility;
    private final Timers timers;
    private final Map<Integer, Running> running = new LinkedHashMap<>();
    private int nextCode;
    private int nextId = 1;

    private static final class Running {
        final int id;
        final BroadcastOrder order;
        final BroadcastSerial serial;
        final List<CellBroadcastPage> pages;
        int sent;
        Timer timer;

        Running(int id, BroadcastOrder order, BroadcastSerial serial) {
            this.id = id;
            this.order = order;
            this.serial = serial;
            this.pages = CellBroadcast.split(order.text(), order.channel(), serial, order.language());
        }

        OptionalInt left() {
            return order.times().isPresent() ? OptionalInt.of(order.times().getAsInt() - sent) : OptionalInt.empty();
        }

        BroadcastView view() {
            return new BroadcastView(
                    id,
                    order.channel(),
                    order.language(),
                    serial.update(),
                    pages.size(),
                    order.period(),
                    sent,
                    left(),
                    order.text());
        }
    }

    /** @param random selects the first message code, because phones remember the codes of an earlier run */
    Broadcaster(MobilityProcedures mobility, Timers timers, RandomGenerator random) {
        this.mobility = mobility;
        this.timers = timers;
        this.nextCode = random.nextInt(CODES);
    }

    /** @throws IllegalArgumentException naming the invalid part of the order */
    BroadcastView broadcast(BroadcastOrder order) {
        Running begun = begin(order);
        send(begun);
        return begun.view();
    }

    private Running begin(BroadcastOrder order) {
        if (order.updated().isPresent()) {
            return update(order, order.updated().getAsInt());
        }
        boolean isRepeated = order.times().isEmpty() || order.times().getAsInt() > 1;
        if (isRepeated && running.size() == MOST_RUNNING) {
            throw new IllegalArgumentException(MOST_RUNNING + " broadcasts are repeated already; stop one first");
        }
        Running begun = new Running(nextId, order, new BroadcastSerial(BroadcastSerial.NETWORK_WIDE, nextCode, 0));
        nextId++;
        nextCode = (nextCode + 1) % CODES;
        return begun;
    }

    /** Keeps the message code and increments the update number, so that phones replace the old text. */
    private Running update(BroadcastOrder order, int id) {
        Running old = running.get(id);
        if (old == null) {
            throw new IllegalArgumentException("no broadcast " + id + " is repeated");
        }
        if (old.order.channel() != order.channel()) {
            throw new IllegalArgumentException(
                    "broadcast " + id + " is on channel " + old.order.channel() + ", not on " + order.channel());
        }
        int update = (old.serial.update() + 1) % UPDATES;
        Running begun = new Running(id, order, new BroadcastSerial(old.serial.scope(), old.serial.code(), update));
        stop(id);
        return begun;
    }

    private void send(Running broadcast) {
        Set<BroadcastChannel> channels = new LinkedHashSet<>();
        mobility.attachedLinks().forEach(link -> channels.add(link.access().broadcastChannel()));
        for (BroadcastChannel channel : channels) {
            broadcast.pages.forEach(page -> channel.broadcast(page.encode()));
        }
        broadcast.sent++;
        if (broadcast.left().orElse(1) > 0) {
            running.put(broadcast.id, broadcast);
            broadcast.timer = timers.start(broadcast.order.period().toNanos(), () -> send(broadcast));
        } else {
            running.remove(broadcast.id);
        }
    }

    /** @return false if the broadcast does not exist, or has ended */
    boolean stop(int id) {
        Running stopped = running.remove(id);
        if (stopped != null) {
            timers.cancel(stopped.timer);
        }
        return stopped != null;
    }

    /** Repeated broadcasts, oldest first. */
    List<BroadcastView> running() {
        return running.values().stream().map(Running::view).toList();
    }
}

package simgsm.modem.at.command;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.function.Predicate;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.modem.at.sms.PduText;
import simgsm.modem.at.sms.TextMode;
import simgsm.modem.at.state.SimMemory;
import simgsm.octets.OctetString;
import simgsm.sms.CellBroadcastPage;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.StatusReportTpdu;
import simgsm.sms.Tpdu;
import simgsm.station.context.StationEvent;
import simgsm.timer.BoundedMap;

/**
 * Received messages: stored on the SIM or passed to clients, as set by +CNMI, with +CMTI, +CMT, +CDS, +CDSI and +CBM.
 *
 * <p>Before the first client connects, no program reads the memory, so a message replaces the oldest if it is full.
 * Later a full memory refuses messages (RP cause 22), and the network keeps them until there is room.
 */
final class MessageCodes {
    private static final int MOST_BUFFERED = 50;
    private static final int PAGES_REMEMBERED = 64;

    /** Values of mt and ds in +CNMI. */
    private static final int INDICATED = 1;

    private static final int DIRECT = 2;
    private static final int CLASS_3_DIRECT = 3;
    private static final int CLASS_3 = 3;

    private final AtModem modem;
    private final SimMemory memory = new SimMemory();
    private Msisdn serviceCenter;
    private boolean isServed;
    private boolean isRefusing;
    private final Map<AtClient, Deque<String>> buffered = new HashMap<>();
    /** Messages passed directly and not yet acknowledged by a client of phase 2+. */
    private final Map<AtClient, Integer> unacknowledged = new HashMap<>();

    /** The cell repeats pages; each is reported once. */
    private final Map<OctetString, Boolean> pages = new BoundedMap<>(PAGES_REMEMBERED);

    MessageCodes(AtModem modem) {
        this.modem = modem;
        serviceCenter = modem.terminal().station().identity().serviceCenter();
    }

    SimMemory memory() {
        return memory;
    }

    Msisdn serviceCenter() {
        return serviceCenter;
    }

    void setServiceCenter(Msisdn newServiceCenter) {
        serviceCenter = newServiceCenter;
    }

    TextMode textMode(AtClient client) {
        return new TextMode(client.settings(), serviceCenter);
    }

    boolean isFull() {
        return memory.isFull();
    }

    boolean hasUnread() {
        for (int index = 1; index <= SimMemory.CAPACITY; index++) {
            if (memory.get(index)
                    .filter(entry -> entry.status() == SimMemory.Status.RECEIVED_UNREAD)
                    .isPresent()) {
                return true;
            }
        }
        return false;
    }

    /** Clients have connected, disconnected, or changed settings. */
    void settingsChanged() {
        isServed |= !modem.clients().isEmpty();
        buffered.keySet().retainAll(modem.clients());
        unacknowledged.keySet().retainAll(modem.clients());
        memoryChanged();
    }

    /** Notifies the network when the memory becomes full, and when it has room again. */
    void memoryChanged() {
        boolean refuses =
                isServed && memory.isFull() && modem.clients().stream().noneMatch(this::isDirect);
        if (refuses != isRefusing) {
            isRefusing = refuses;
            modem.terminal().setMemoryAvailable(!refuses);
        }
        modem.network().check();
    }

    private boolean isDirect(AtClient client) {
        return client.settings().deliverMode == DIRECT;
    }

    // ---- arrivals -----------------------------------------------------------------------------------------------

    void accept(StationEvent.OfMessage event) {
        if (event instanceof StationEvent.TransferUnitReceived received) {
            arrived(received.tpdu());
        } else if (event instanceof StationEvent.BroadcastPageReceived page) {
            pageArrived(page.octets());
        }
    }

    private void arrived(OctetString octets) {
        Tpdu tpdu;
        try {
            tpdu = PduText.decode(octets);
        } catch (ProtocolViolation cannotBe) {
            throw new IllegalStateException("the station has taken a broken unit", cannotBe);
        }
        if (tpdu instanceof DeliverTpdu deliver) {
            delivered(octets, deliver);
        } else if (tpdu instanceof StatusReportTpdu report) {
            reported(octets, report);
        }
    }

    private void delivered(OctetString octets, DeliverTpdu deliver) {
        boolean isOfClass3 = deliver.userData().coding().messageClass().orElse(-1) == CLASS_3;
        Predicate<AtClient> direct =
                client -> isDirect(client) || client.settings().deliverMode == CLASS_3_DIRECT && isOfClass3;
        if (modem.clients().stream().noneMatch(direct)) {
            int place = store(octets);
            to(client -> client.settings().deliverMode != 0, client -> "+CMTI: \"SM\"," + place, AtClient::announce);
            return;
        }
        PduText pdu = new PduText(serviceCenter, octets);
        to(direct, client -> {
            if (client.settings().acknowledges) {
                unacknowledged.merge(client, 1, Integer::sum);
            }
            return client.settings().textMode
                    ? "+CMT: " + textMode(client).delivered(octets, deliver)
                    : "+CMT: ," + pdu.length() + "\r\n" + pdu.digits();
        });
    }

    /** @return the place */
    private int store(OctetString octets) {
        if (memory.isFull()) {
            memory.removeOldest();
        }
        int place = memory.add(SimMemory.Status.RECEIVED_UNREAD, octets).orElseThrow();
        memoryChanged();
        return place;
    }

    /** A report to be stored is dropped if there is no room: it must not replace a message. */
    private void reported(OctetString octets, StatusReportTpdu report) {
        PduText pdu = new PduText(serviceCenter, octets);
        to(
                client -> client.settings().reportMode == INDICATED,
                client -> client.settings().textMode
                        ? "+CDS: " + textMode(client).report(octets, report)
                        : "+CDS: " + pdu.length() + "\r\n" + pdu.digits());
        Predicate<AtClient> stored = client -> client.settings().reportMode == DIRECT;
        if (modem.clients().stream().anyMatch(stored)) {
            OptionalInt place = memory.add(SimMemory.Status.RECEIVED_UNREAD, octets);
            memoryChanged();
            if (place.isPresent()) {
                to(stored, client -> "+CDSI: \"SM\"," + place.getAsInt(), AtClient::announce);
            }
        }
    }

    private void pageArrived(OctetString octets) {
        CellBroadcastPage page;
        try {
            page = CellBroadcastPage.decode(octets);
        } catch (ProtocolViolation cannotBe) {
            throw new IllegalStateException("the station has taken a broken page", cannotBe);
        }
        if (pages.put(octets, true) == null) {
            to(
                    client -> client.settings().broadcastMode == DIRECT
                            && client.settings().channels.contains(page.messageIdentifier()),
                    client -> client.settings().textMode
                            ? "+CBM: " + textMode(client).page(page)
                            : "+CBM: " + octets.length() + "\r\n"
                                    + octets.toString().toUpperCase(Locale.ROOT));
        }
    }

    private void to(Predicate<AtClient> wish, Function<AtClient, String> code) {
        to(wish, code, AtClient::report);
    }

    private void to(Predicate<AtClient> wish, Function<AtClient, String> code, BiConsumer<AtClient, String> way) {
        for (AtClient client : modem.clients()) {
            if (!wish.test(client)) {
                continue;
            }
            String text = code.apply(client);
            if (client.settings().indicationMode > 0) {
                way.accept(client, text);
            } else {
                buffer(client, text);
            }
        }
    }

    /** Mode 0 of +CNMI keeps codes in the modem. */
    private void buffer(AtClient client, String text) {
        Deque<String> codes = buffered.computeIfAbsent(client, key -> new ArrayDeque<>());
        if (codes.size() == MOST_BUFFERED) {
            codes.remove();
        }
        codes.add(text);
    }

    /** +CNMI was set: kept codes are sent, or dropped for bfr 1. */
    void indicationsSet(AtClient client) {
        if (client.settings().indicationMode > 0) {
            Deque<String> codes = Optional.ofNullable(buffered.remove(client)).orElseGet(ArrayDeque::new);
            if (client.settings().bufferMode == 0) {
                List.copyOf(codes).forEach(client::report);
            }
        }
        settingsChanged();
    }

    /** +CNMA. @return false if no acknowledgement is expected */
    boolean acknowledge(AtClient client) {
        int waiting = unacknowledged.getOrDefault(client, 0);
        unacknowledged.put(client, Math.max(0, waiting - 1));
        return waiting > 0;
    }
}

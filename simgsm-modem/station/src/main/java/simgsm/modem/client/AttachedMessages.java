package simgsm.modem.client;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.air.Direction;
import simgsm.air.Msisdn;
import simgsm.air.ProtocolViolation;
import simgsm.air.RpCause;
import simgsm.octets.OctetString;
import simgsm.octets.Octets;
import simgsm.sms.DeliverTpdu;
import simgsm.sms.MessageSplitter;
import simgsm.sms.Reassembler;
import simgsm.sms.SmsAddress;
import simgsm.sms.SubmitTpdu;
import simgsm.sms.TpduCodec;
import simgsm.sms.UserData;
import simgsm.sms.ValidityPeriod;
import simgsm.station.context.StationEvent;
import simgsm.timer.BoundedMap;
import simgsm.timer.Timers;

/**
 * Short messages of an attached modem. A received message is read twice, because the line may be disturbed, erased,
 * and then reported once, even if erasing failed; messages stored in the modem before the start are not reported. A
 * message to send waits up to 10 minutes for the modem; one refused by the network is tried three times.
 */
final class AttachedMessages {
    /** As for M2's replies. */
    static final int MAX_KEPT = 20;

    static final long MAX_AGE_NANOS = TimeUnit.MINUTES.toNanos(10);

    private static final Logger LOG = System.getLogger(AttachedMessages.class.getName());
    /** RP causes as for M2's replies, and "no network service" and "network timeout" (TS 27.005, 3.2.5). */
    private static final Set<Integer> TEMPORARY = Set.of(38, 42, 47, 331, 332);

    private static final int MOST_TRIES = 3;
    private static final int MAX_READINGS = 4;
    private static final int MAX_REMEMBERED = 64;
    /** Time-out during a call, after which the modem is taken for lost. */
    private static final long LIMIT_IN_CALL_MILLIS = 10_000;

    /** The content of one command. @param next the part, from 0; @param tries number of its refusals */
    private record Outgoing(int id, Msisdn to, String text, int next, int tries, long sinceNanos) {
        Outgoing with(int nextPart, int refusedTries) {
            return new Outgoing(id, to, text, nextPart, refusedTries, sinceNanos);
        }
    }

    private final Instant start;

    private final CommandDialogue dialogue;
    private final Timers timers;
    private final Consumer<StationEvent> listener;
    private final Deque<Outgoing> waiting = new ArrayDeque<>();
    private final Reassembler reassembler = new Reassembler();
    /** The newest messages reported, and the addresses of their senders by digits. */
    private final Map<String, Boolean> reported = new BoundedMap<>(MAX_REMEMBERED);

    private final Map<String, SmsAddress> senders = new BoundedMap<>(MAX_REMEMBERED);
    private ModemSetup setup;
    private boolean ready;
    private boolean sending;
    private boolean inCall;
    private int nextId;

    /** @param start of the program: messages accepted by the network before, and stored in the modem, are old */
    AttachedMessages(CommandDialogue dialogue, Timers timers, Instant start, Consumer<StationEvent> listener) {
        this.start = start;
        this.dialogue = dialogue;
        this.timers = timers;
        this.listener = listener;
    }

    /** The modem is ready: fetches and sends waiting messages. */
    void ready(ModemSetup whatItCan) {
        setup = whatItCan;
        ready = true;
        sending = false;
        fetchAll();
        sendNext();
    }

    void modemLost() {
        ready = false;
        sending = false;
    }

    void setInCall(boolean active) {
        inCall = active;
    }

    /** Fetches messages with a lost notice, and repeats those that failed for lack of service. */
    void lookAgain() {
        fetchAll();
        sendNext();
    }

    // ---- received --------------------------------------------------------------------------------------------------

    private void fetchAll() {
        if (!ready || !setup.has(SetupStep.MESSAGE_LIST)) {
            return;
        }
        dialogue.send(
                setup.command(SetupStep.MESSAGE_LIST),
                answer -> answer.lines().stream()
                        .filter(line -> line.startsWith("+CMGL:"))
                        .map(AnswerFields::of)
                        .filter(AttachedMessages::isReceived)
                        .forEach(fields -> fetch(fields.number(0), true)));
    }

    /** Stored messages to be sent, 2 and 3, are ignored. */
    private static boolean isReceived(AnswerFields fields) {
        return fields.number(1) == 0 || fields.number(1) == 1 || fields.text(1).startsWith("REC");
    }

    /** {@code +CMTI: "SM",index}. */
    void stored(String notice) {
        fetch(AnswerFields.of(notice).number(1), false);
    }

    /** @param isListed true if it was stored before its notice could be seen */
    private void fetch(int index, boolean isListed) {
        if (ready && index >= 0 && setup.has(SetupStep.MESSAGE_FORMAT)) {
            read(index, isListed, "", 1);
        }
    }

    private void read(int index, boolean isListed, String before, int reading) {
        ModemCommand command = ModemCommand.listing("AT+CMGR=" + index, "+CMGR:");
        dialogue.send(inCall ? command.within(LIMIT_IN_CALL_MILLIS) : command, answer -> {
            if (!answer.isOk() || answer.lines().isEmpty()) {
                return;
            }
            String content = content(answer.lines());
            if (content.equals(before)) {
                erase(index, isListed, answer.lines());
            } else if (reading < MAX_READINGS) {
                read(index, isListed, content, reading + 1);
            } else {
                LOG.log(Level.WARNING, "message " + index + " is read differently each time; it is left");
            }
        });
    }

    /** All but the status, which changes with the first reading. */
    private static String content(List<String> lines) {
        return lines.get(0).replaceFirst("^\\+CMGR: *[^,]*", "")
                + "\n"
                + String.join("\n", lines.subList(1, lines.size()));
    }

    private void erase(int index, boolean isListed, List<String> lines) {
        // even if erasing fails: a message read again is not reported again
        dialogue.send(ModemCommand.of("AT+CMGD=" + index), answer -> report(lines, isListed));
    }

    private void report(List<String> lines, boolean isListed) {
        if (reported.put(content(lines), true) != null) {
            return;
        }
        if (isPduMode()) {
            reportPdu(lines.size() > 1 ? lines.get(1) : "", isListed);
        } else {
            AnswerFields header = AnswerFields.of(lines.get(0));
            received(header.quoted(1), String.join("\n", lines.subList(1, lines.size())));
        }
    }

    /** A message not stored by the modem. */
    void arrived(String pdu) {
        if (isPduMode() && reported.put(pdu, true) == null) {
            reportPdu(pdu, false);
        }
    }

    private boolean isPduMode() {
        return setup != null
                && setup.has(SetupStep.MESSAGE_FORMAT)
                && setup.command(SetupStep.MESSAGE_FORMAT).text().endsWith("=0");
    }

    private void reportPdu(String pdu, boolean isListed) {
        try {
            OctetString octets = OctetString.ofHex(pdu);
            int serviceCenterOctets = 1 + octets.octet(0);
            byte[] tpdu = Octets.range(octets.toArray(), serviceCenterOctets, octets.length());
            if (TpduCodec.decode(OctetString.of(tpdu), Direction.DOWNLINK) instanceof DeliverTpdu deliver) {
                Instant sent = deliver.timestamp().toOffsetDateTime().toInstant();
                if (isListed && sent.isBefore(start)) {
                    LOG.log(Level.INFO, "a message of " + sent + ", from before the start, is erased and not answered");
                    return;
                }
                reassembler
                        .accept(deliver.originator(), deliver.userData(), timers.nowNanos())
                        .ifPresent(text -> {
                            senders.put(deliver.originator().value(), deliver.originator());
                            received(deliver.originator().value(), text);
                        });
            }
        } catch (ProtocolViolation | RuntimeException damaged) {
            LOG.log(Level.WARNING, "a message that cannot be read: " + damaged.getMessage());
        }
    }

    private void received(String from, String text) {
        if (from.startsWith("+")) {
            // a damaged number cannot be answered; its message is reported nevertheless
            AttachedCall.number(from).ifPresent(number -> senders.put(number.digits(), SmsAddress.of(number)));
        }
        listener.accept(new StationEvent.ShortMessageReceived(from, text));
    }

    // ---- sent ------------------------------------------------------------------------------------------------------

    int send(Msisdn to, String text) {
        int id = nextId++;
        if (waiting.size() == MAX_KEPT) {
            fail(waiting.remove(), RpCause.NETWORK_OUT_OF_ORDER);
        }
        waiting.add(new Outgoing(id, to, text, 0, 0, timers.nowNanos()));
        sendNext();
        return id;
    }

    private void fail(Outgoing message, RpCause cause) {
        listener.accept(new StationEvent.MessageFailed(message.id(), message.to(), cause));
    }

    private void sendNext() {
        while (!waiting.isEmpty() && timers.nowNanos() - waiting.element().sinceNanos() >= MAX_AGE_NANOS) {
            fail(waiting.remove(), RpCause.NETWORK_OUT_OF_ORDER);
        }
        if (ready && !sending && !waiting.isEmpty() && setup.has(SetupStep.MESSAGE_FORMAT)) {
            sending = true;
            Outgoing message = waiting.element();
            ModemCommand command = isPduMode() ? pdu(message) : text(message);
            dialogue.send(inCall ? command.within(LIMIT_IN_CALL_MILLIS) : command, answer -> answered(message, answer));
        }
    }

    private void answered(Outgoing message, ModemAnswer answer) {
        if (!sending || waiting.peek() != message) {
            return;
        }
        sending = false;
        if (answer.isOk()) {
            waiting.remove();
            int parts = isPduMode() ? parts(message).size() : 1;
            if (message.next() + 1 < parts) {
                waiting.addFirst(message.with(message.next() + 1, 0));
            } else {
                listener.accept(new StationEvent.MessageSent(message.id(), message.to(), parts));
            }
        } else if (answer.ending() == ModemAnswer.Ending.REFUSED) {
            int number = answer.errorNumber().orElse(RpCause.TEMPORARY_FAILURE.code());
            boolean isTriedAgain = TEMPORARY.contains(number) || isUnclear(number) && message.tries() + 1 < MOST_TRIES;
            waiting.remove();
            if (isTriedAgain) {
                // by the next look, after 30 s
                waiting.addFirst(message.with(message.next(), message.tries() + 1));
                return;
            }
            fail(message, number <= 0x7f ? RpCause.ofCode(number) : RpCause.TEMPORARY_FAILURE);
        } else {
            return;
        }
        sendNext();
    }

    /** A temporary failure, or an error of the modem without a cause of the network. */
    private static boolean isUnclear(int number) {
        return number == RpCause.TEMPORARY_FAILURE.code() || number > 0x7f;
    }

    private static List<UserData> parts(Outgoing message) {
        return MessageSplitter.split(message.text(), message.id() & 0xff);
    }

    private SmsAddress address(Msisdn to) {
        return Optional.ofNullable(senders.get(to.digits())).orElseGet(() -> SmsAddress.of(to));
    }

    /** The service centre is the SIM's; its octets are not counted (TS 27.005, 3.5.1 and 4.3). */
    private ModemCommand pdu(Outgoing message) {
        SubmitTpdu submit = new SubmitTpdu(
                false,
                false,
                false,
                message.id() & 0xff,
                address(message.to()),
                0,
                Optional.of(ValidityPeriod.Relative.ONE_DAY),
                parts(message).get(message.next()));
        OctetString tpdu = TpduCodec.encode(submit);
        return ModemCommand.prompting(
                "AT+CMGS=" + tpdu.length(), "00" + tpdu.toString().toUpperCase(Locale.ROOT), "+CMGS:");
    }

    private ModemCommand text(Outgoing message) {
        SmsAddress address = address(message.to());
        return ModemCommand.prompting(
                "AT+CMGS=\"" + address + "\"", message.text().replaceAll("[\\u001a\\u001b]", " "), "+CMGS:");
    }
}

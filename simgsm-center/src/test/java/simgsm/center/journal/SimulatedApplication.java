package simgsm.center.journal;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import simgsm.center.msc.Exchange;
import simgsm.center.smpp.EsmeSession;
import simgsm.center.smpp.SmppPort;
import simgsm.center.smpp.SmppServer;
import simgsm.octets.OctetString;
import simgsm.smpp.SmppAddress;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;

/** An application that serves a number over SMPP: it answers late, refuses, vanishes, and shows each message once. */
final class SimulatedApplication implements SmppPort {
    static final String NUMBER = "5550300";

    private static final int RECEIPT = 0x04;
    private static final int USER_MESSAGE_REFERENCE = 0x0204;
    private static final int MESSAGE_STATE = 0x0427;
    private static final int RECEIPTED_MESSAGE_ID = 0x001e;

    private final SplittableRandom random;
    private final Account account;
    private final Map<Integer, Account.Key> submitted = new HashMap<>();
    private final Deque<SmppPdu.Message> unanswered = new ArrayDeque<>();
    private final Set<Integer> seen = new HashSet<>();
    private final Map<String, Integer> receipts = new HashMap<>();
    private final List<byte[]> toSend = new ArrayList<>();
    private EsmeSession session;
    private boolean isBound;
    private boolean isDropped;
    private int sequence;

    SimulatedApplication(SplittableRandom random, Account account) {
        this.random = random;
        this.account = account;
    }

    /** Connects and binds, unless it has. */
    void bind(Exchange exchange, SmppServer smpp, long nowNanos) {
        if (session == null) {
            exchange.perform(nowNanos, () -> session = smpp.opened(this, "simulated", true));
            say(new SmppPdu.Bind(SmppCommand.BIND_TRANSCEIVER, ++sequence, "app", "", "", 0x34, NUMBER));
        }
    }

    /** The message is not always valid for long, and not always receipted. */
    void submit(String to, String text) {
        if (isBound) {
            Account.Key key = new Account.Key(NUMBER, to, text);
            account.written(key);
            submitted.put(++sequence, key);
            String validity = random.nextInt(4) == 0 ? "0000000000" + (10 + random.nextInt(50)) + "000R" : "";
            SmppMessage message = new SmppMessage(
                    "",
                    new SmppAddress(1, 1, NUMBER),
                    new SmppAddress(1, 1, to),
                    0,
                    0,
                    0,
                    "",
                    validity,
                    random.nextInt(3),
                    0,
                    0,
                    0,
                    OctetString.of(text.getBytes(StandardCharsets.US_ASCII)),
                    List.of());
            say(new SmppPdu.Message(SmppCommand.SUBMIT_SM, sequence, message));
        }
    }

    /** Answers the oldest message. @param isWilling whether it takes everything */
    void answer(boolean isWilling) {
        SmppPdu.Message next = unanswered.poll();
        if (next != null) {
            int status = isReceipt(next) ? SmppStatus.OK : take(next.message(), isWilling);
            say(new SmppPdu.MessageResponse(SmppCommand.DELIVER_SM, status, next.sequence(), ""));
        }
    }

    private int take(SmppMessage message, boolean isWilling) {
        int reference = number(message, USER_MESSAGE_REFERENCE);
        if (seen.contains(reference)) {
            return SmppStatus.OK;
        }
        int mood = isWilling ? 2 : random.nextInt(12);
        if (mood == 0) {
            return random.nextBoolean() ? SmppStatus.THROTTLED : SmppStatus.TEMPORARY_APPLICATION_ERROR;
        }
        if (mood == 1) {
            return SmppStatus.SUBMIT_FAILED;
        }
        seen.add(reference);
        account.shown(new Account.Key(message.source().value(), NUMBER, text(message)));
        return SmppStatus.OK;
    }

    private static boolean isReceipt(SmppPdu.Message delivery) {
        return (delivery.message().esmClass() & RECEIPT) != 0;
    }

    private static String text(SmppMessage message) {
        return new String(message.shortMessage().toArray(), StandardCharsets.US_ASCII);
    }

    private static int number(SmppMessage message, int tag) {
        int number = 0;
        for (byte octet : parameter(message, tag)) {
            number = number << 8 | octet & 0xff;
        }
        return number;
    }

    private static byte[] parameter(SmppMessage message, int tag) {
        return message.parameters().stream()
                .filter(each -> each.tag() == tag)
                .findFirst()
                .orElseThrow(() -> new AssertionError("no parameter " + tag))
                .value()
                .toArray();
    }

    private void say(SmppPdu pdu) {
        toSend.add(SmppCodec.encode(pdu));
    }

    /** What it has said reaches the centre, in pieces of any length. @return whether there was anything */
    boolean carry(Exchange exchange, long nowNanos) {
        if (session == null || toSend.isEmpty()) {
            return false;
        }
        int length = toSend.stream().mapToInt(pdu -> pdu.length).sum();
        ByteBuffer all = ByteBuffer.allocate(length);
        toSend.forEach(all::put);
        toSend.clear();
        all.flip();
        while (all.hasRemaining() && session != null) {
            ByteBuffer piece = all.slice(all.position(), 1 + random.nextInt(all.remaining()));
            all.position(all.position() + piece.remaining());
            EsmeSession to = session;
            exchange.perform(nowNanos, () -> to.received(piece));
        }
        return true;
    }

    void leave(Exchange exchange, long nowNanos) {
        if (session != null) {
            EsmeSession gone = session;
            disconnected();
            exchange.perform(nowNanos, () -> gone.closed("left"));
        }
    }

    boolean isDropped() {
        return isDropped;
    }

    boolean hasUnanswered() {
        return !unanswered.isEmpty();
    }

    /** The connection is gone on this side. */
    void disconnected() {
        session = null;
        isBound = false;
        isDropped = false;
        submitted.clear();
        unanswered.clear();
        toSend.clear();
    }

    @Override
    public void send(byte[] octets) {
        try {
            heard(SmppCodec.decode(octets));
        } catch (SmppViolation violation) {
            throw new AssertionError(violation.getMessage(), violation);
        }
    }

    private void heard(SmppPdu pdu) {
        if (pdu instanceof SmppPdu.BindResponse response) {
            Invariant.holds(response.status() == SmppStatus.OK, () -> "not bound: " + response);
            isBound = true;
        } else if (pdu instanceof SmppPdu.MessageResponse response) {
            Account.Key key = submitted.remove(response.sequence());
            Invariant.holds(key != null, () -> "an answer to nothing: " + response);
            if (response.status() == SmppStatus.OK) {
                account.acknowledged(key);
            }
        } else if (pdu instanceof SmppPdu.PlainResponse response) {
            submitted.remove(response.sequence());
        } else if (pdu instanceof SmppPdu.Message delivery) {
            if (isReceipt(delivery)) {
                receipt(delivery.message());
            }
            unanswered.add(delivery);
        } else if (pdu instanceof SmppPdu.Plain request) {
            say(new SmppPdu.PlainResponse(request.command(), SmppStatus.OK, request.sequence()));
        }
    }

    /** A receipt may come again, but it never says anything else. */
    private void receipt(SmppMessage message) {
        String id = new String(parameter(message, RECEIPTED_MESSAGE_ID), StandardCharsets.US_ASCII);
        int state = number(message, MESSAGE_STATE);
        Integer before = receipts.put(id, state);
        Invariant.holds(
                before == null || before == state,
                () -> "message " + id + " is in state " + before + ", then " + state);
    }

    @Override
    public void closeWhenSent() {
        isDropped = true;
    }

    @Override
    public void close(String reason) {
        isDropped = true;
    }
}

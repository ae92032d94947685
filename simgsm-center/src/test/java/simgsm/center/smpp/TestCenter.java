package simgsm.center.smpp;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Queue;
import java.util.Set;
import java.util.function.Consumer;
import simgsm.air.Msisdn;
import simgsm.center.smsc.DeliveryOutcome;
import simgsm.center.smsc.DeliveryPort;
import simgsm.center.smsc.Destination;
import simgsm.center.smsc.Envelope;
import simgsm.center.smsc.MessageStore;
import simgsm.center.smsc.ShortMessageCenter;
import simgsm.smpp.SmppCodec;
import simgsm.smpp.SmppCommand;
import simgsm.smpp.SmppMessage;
import simgsm.smpp.SmppPdu;
import simgsm.smpp.SmppStatus;
import simgsm.smpp.SmppViolation;
import simgsm.timer.CivilTime;
import simgsm.timer.Timers;

/** The core without sockets: applications as lists of PDUs, a clock moved by hand, a store that answers when told. */
final class TestCenter {
    static final Instant START = Instant.parse("2026-11-21T12:00:45Z");

    final Timers timers = new Timers();
    final SmppServer server = new SmppServer();
    final Set<String> subscribers = new HashSet<>();
    final Queue<Long> tickets = new ArrayDeque<>();
    final ShortMessageCenter center = new ShortMessageCenter(
            new CivilTime(START, timers),
            timers,
            (ticket, entry) -> tickets.add(ticket),
            new Applications(),
            (message, state) -> {});

    /** The applications, and subscribers of whom none is there. */
    private final class Applications implements DeliveryPort {
        @Override
        public boolean isSubscriber(Msisdn number) {
            return subscribers.contains(number.digits());
        }

        @Override
        public boolean isReachable(Destination destination) {
            return server.routes().isReachable(destination);
        }

        @Override
        public int window(Destination destination) {
            return server.routes().window(destination);
        }

        @Override
        public void deliver(Envelope envelope, boolean moreWaiting, Consumer<DeliveryOutcome> ended) {
            server.routes().deliver(envelope, moreWaiting, ended);
        }

        @Override
        public void emptied(Destination destination) {
            server.routes().emptied(destination);
        }
    }

    TestCenter() {
        server.serve(center, timers);
    }

    /** The store has made everything durable. */
    void commit() {
        while (!tickets.isEmpty()) {
            long ticket = tickets.remove();
            if (ticket != MessageStore.NO_TICKET) {
                center.committed(ticket, true);
            }
        }
    }

    void passSeconds(long seconds) {
        timers.advance(timers.nowNanos() + seconds * 1_000_000_000L);
    }

    Application open(boolean isLocal) {
        return open(isLocal, "test");
    }

    Application open(boolean isLocal, String address) {
        return new Application(isLocal, address);
    }

    Application bound(SmppCommand command, String systemId, String range) {
        Application application = open(true);
        application.say(new SmppPdu.Bind(command, 1, systemId, "", "", 0x34, range));
        SmppPdu first = application.heard.remove(0);
        if (!(first instanceof SmppPdu.BindResponse response) || response.status() != SmppStatus.OK) {
            throw new AssertionError("not bound: " + first);
        }
        return application;
    }

    final class Application implements SmppPort {
        final List<SmppPdu> heard = new ArrayList<>();
        byte[] lastOctets;
        private final EsmeSession session;
        boolean isEnding;
        boolean hasBound;
        String closed = "";

        private Application(boolean isLocal, String address) {
            session = server.opened(this, address, isLocal);
        }

        void say(SmppPdu pdu) {
            say(SmppCodec.encode(pdu));
        }

        void say(byte[] octets) {
            session.received(java.nio.ByteBuffer.wrap(octets));
        }

        void submit(int sequence, SmppMessage message) {
            say(new SmppPdu.Message(SmppCommand.SUBMIT_SM, sequence, message));
        }

        /** The latest PDU, which must be of this kind. */
        <T extends SmppPdu> T last(Class<T> kind) {
            return kind.cast(heard.get(heard.size() - 1));
        }

        <T extends SmppPdu> List<T> all(Class<T> kind) {
            return heard.stream().filter(kind::isInstance).map(kind::cast).toList();
        }

        void answer(SmppPdu.Message delivery, int status) {
            say(new SmppPdu.MessageResponse(SmppCommand.DELIVER_SM, status, delivery.sequence(), ""));
        }

        void leave() {
            session.closed("test");
        }

        EsmeSession session() {
            return session;
        }

        @Override
        public void send(byte[] pdu) {
            lastOctets = pdu;
            try {
                heard.add(SmppCodec.decode(pdu));
            } catch (SmppViolation violation) {
                throw new AssertionError(violation);
            }
        }

        @Override
        public void bound() {
            hasBound = true;
        }

        @Override
        public void closeWhenSent() {
            isEnding = true;
        }

        @Override
        public void close(String reason) {
            closed = reason;
        }
    }
}

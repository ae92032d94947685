package simgsm.gateway.sip;

import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import simgsm.timer.Timers;

/** The transactions with all phones (RFC 3261, 17), found by branch, host, method and CSeq (17.1.3, 17.2.3). */
final class SipTransactions {
    /** Round-trip estimate, longest repetition, lifetime of messages in the network (17.1.1.1, table 4). */
    static final long T1_NANOS = TimeUnit.MILLISECONDS.toNanos(500);

    static final long T2_NANOS = TimeUnit.SECONDS.toNanos(4);
    static final long T4_NANOS = TimeUnit.SECONDS.toNanos(5);
    /** Timers B, F, H, J: 64 times T1. */
    static final long LIMIT_NANOS = 64 * T1_NANOS;

    /** Maximum of requests that are answered at the same time; more are dropped, and repeated by their clients. */
    static final int MOST = 5_000;

    private static final int WORD_OCTETS = 8;
    /** Beginning of each branch (8.1.1.7). */
    private static final String COOKIE = "z9hG4bK";

    private final Timers timers;
    private final RandomGenerator random;
    private final SipTransport transport;
    private final Map<String, ServerTransaction> servers = new HashMap<>();
    private final Map<String, ClientTransaction> clients = new HashMap<>();

    SipTransactions(Timers timers, RandomGenerator random, SipTransport transport) {
        this.timers = timers;
        this.random = random;
        this.transport = transport;
    }

    Timers timers() {
        return timers;
    }

    void transmit(byte[] octets, SipPeer peer) {
        transport.send(octets, peer);
    }

    /** A word for tags, branches and nonces: 64 random bits. */
    String randomWord() {
        byte[] octets = new byte[WORD_OCTETS];
        random.nextBytes(octets);
        return HexFormat.of().formatHex(octets);
    }

    /** A branch for a request of its own. */
    String branch() {
        return COOKIE + randomWord();
    }

    private static String serverKey(SipMessage request, String method) {
        SipValue via = request.via();
        String branch = via.parameter("branch").orElse("");
        // before RFC 3261 branches were not unique; pyVoIP 1.6.8 keeps one for the INVITE with credentials
        String old = branch.startsWith(COOKIE)
                ? ""
                : request.callId() + request.address("From").tag();
        return branch + " " + via.main() + " " + method + " " + request.cseq() + " " + old;
    }

    /** The transaction of a repeated request, of ACK, or of the request that CANCEL cancels. */
    Optional<ServerTransaction> serverOf(SipMessage request) {
        boolean isOfInvite = request.method().equals("ACK") || request.method().equals("CANCEL");
        return Optional.ofNullable(servers.get(serverKey(request, isOfInvite ? "INVITE" : request.method())));
    }

    boolean isFull() {
        return servers.size() >= MOST;
    }

    ServerTransaction open(SipMessage request, SipPeer peer) {
        ServerTransaction transaction = new ServerTransaction(request, peer, this);
        servers.put(serverKey(request, request.method()), transaction);
        return transaction;
    }

    ClientTransaction request(SipMessage request, SipPeer peer, Consumer<SipMessage> listener) {
        ClientTransaction transaction = new ClientTransaction(request, peer, this, listener);
        clients.put(clientKey(request), transaction);
        return transaction;
    }

    private static String clientKey(SipMessage message) {
        return message.via().parameter("branch").orElse("") + " " + message.method();
    }

    void responded(SipMessage response) {
        ClientTransaction transaction = clients.get(clientKey(response));
        if (transaction != null) {
            transaction.arrived(response);
        }
    }

    void remove(ServerTransaction transaction) {
        servers.remove(serverKey(transaction.request(), transaction.request().method()), transaction);
    }

    void remove(ClientTransaction transaction) {
        clients.remove(clientKey(transaction.request()), transaction);
    }

    /** A Via of this side (18.1.1). */
    String via(SipPeer peer) {
        return "SIP/2.0/UDP " + SipPeer.inUri(transport.hostTowards(peer)) + ":" + transport.port() + ";branch="
                + branch() + ";rport";
    }
}

package simgsm.gateway.sip;

import java.lang.System.Logger.Level;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.random.RandomGenerator;
import simgsm.air.Msisdn;
import simgsm.timer.RecentCounts;
import simgsm.timer.Timers;

/**
 * Registrar and user agent of the gateway (RFC 3261, 8 and 10), as a core: datagrams and time go in, datagrams and
 * stations come out. One owner thread calls everything.
 */
public final class SipServer {
    /** Maximum of registered phones. */
    public static final int MOST_USERS = 200;

    static final String METHODS = "INVITE, ACK, BYE, CANCEL, OPTIONS, INFO, MESSAGE, REGISTER";

    private static final System.Logger LOG = System.getLogger(SipServer.class.getName());
    private static final int LEAST_SECONDS = 60;
    private static final int MOST_SECONDS = 3600;
    private static final String TEXT = "text/plain";

    /** Reports that phones send by MESSAGE: they are no messages of their users. */
    private static final List<String> REPORTS = List.of("application/im-iscomposing+xml", "message/imdn+xml");

    private final SipContext context;
    private final Map<String, String> passwords;
    private final SipListener listener;
    private final SipDigest digest;
    /** Wrong passwords by address: after 10 a minute all of its requests are refused unread. */
    private final RecentCounts guesses = new RecentCounts(10, TimeUnit.MINUTES.toNanos(1));

    private final Map<String, SipUser> users = new TreeMap<>();

    /**
     * A server without users.
     *
     * @param passwords by number
     * @param random for stations and speech
     * @param secret for nonces and tags
     */
    public SipServer(
            Timers timers,
            SipTransport transport,
            Map<String, String> passwords,
            RandomGenerator random,
            RandomGenerator secret,
            SipListener listener) {
        SipTransactions transactions = new SipTransactions(timers, secret, transport);
        context = new SipContext(timers, random, transport, transactions);
        digest = new SipDigest(transactions::randomWord);
        this.passwords = passwords;
        this.listener = listener;
    }

    public Collection<SipUser> users() {
        return users.values();
    }

    SipListener listener() {
        return listener;
    }

    void gone(SipUser user) {
        users.remove(user.number().digits(), user);
    }

    /** Ends a user's call and registration. @return false if no phone has registered the number */
    public boolean drop(Msisdn number) {
        Optional<SipUser> user = user(number.digits());
        user.ifPresent(SipUser::leave);
        return user.isPresent();
    }

    /** Ends all calls. */
    public void close() {
        List.copyOf(users.values()).forEach(SipUser::unbind);
    }

    private Optional<SipUser> user(String number) {
        return Optional.ofNullable(users.get(number)).filter(user -> !user.isLeaving());
    }

    /** A datagram on the port of SIP. */
    public void arrived(byte[] octets, SipPeer from) {
        // keep-alives: line ends (RFC 5626, 4.4.1) and STUN
        if (octets.length <= 4 || octets[0] < ' ') {
            return;
        }
        SipMessage message;
        try {
            message = SipMessage.parse(octets);
        } catch (SipSyntaxException e) {
            LOG.log(Level.DEBUG, "SIP from {0}: dropped, {1}", from, e.getMessage());
            return;
        }
        if (!message.isRequest()) {
            context.transactions().responded(message);
        } else if (!message.isComplete()) {
            badRequest(message, from);
        } else {
            message.receivedFrom(from);
            request(message, from);
        }
    }

    private void badRequest(SipMessage message, SipPeer from) {
        if (!message.values("Via").isEmpty() && !message.method().equals("ACK")) {
            SipMessage answer = message.response(400, "Bad Request: expected Via, From, To, Call-ID and CSeq");
            context.transport().send(answer.encode(), from);
        }
    }

    private void request(SipMessage message, SipPeer from) {
        Optional<ServerTransaction> known = context.transactions().serverOf(message);
        if (message.method().equals("ACK")) {
            known.ifPresent(ServerTransaction::acknowledged);
            call(message).ifPresent(call -> call.acknowledged(message));
        } else if (known.isPresent() && !message.method().equals("CANCEL")) {
            known.get().repeated();
        } else if (!context.transactions().isFull()) {
            Optional<SipCall> call = call(message);
            if (call.isEmpty() || !call.get().isHeldBack(message)) {
                first(context.transactions().open(message, from), known, call);
            }
        }
    }

    private Optional<SipCall> call(SipMessage message) {
        return users.values().stream()
                .flatMap(user -> user.call().stream())
                .filter(call -> call.has(message))
                .findFirst();
    }

    /** @param cancelled the transaction with the branch of a CANCEL */
    private void first(ServerTransaction request, Optional<ServerTransaction> cancelled, Optional<SipCall> call) {
        SipMessage message = request.request();
        List<String> required = message.values("Require");
        if (message.method().equals("CANCEL")) {
            cancel(request, cancelled);
        } else if (!required.isEmpty()) {
            request.send(request.response(420, "Bad Extension").with("Unsupported", String.join(", ", required)));
        } else if (!message.uri().toLowerCase(Locale.ROOT).startsWith("sip:")) {
            request.respond(416, "Unsupported URI Scheme: expected sip:");
        } else if (!List.of(METHODS.split(", ")).contains(message.method())) {
            boolean isOfEvents =
                    message.method().equals("SUBSCRIBE") || message.method().equals("PUBLISH");
            request.send((isOfEvents ? request.response(489, "Bad Event") : request.response(405, "Method Not Allowed"))
                    .with("Allow", METHODS));
        } else if (call.isPresent() && !message.method().equals("MESSAGE")) {
            call.get().request(request);
        } else if (!message.address("To").tag().isEmpty() && !message.method().equals("MESSAGE")) {
            request.respond(481, "Call/Transaction Does Not Exist");
        } else {
            outsideCall(request);
        }
    }

    private void cancel(ServerTransaction request, Optional<ServerTransaction> cancelled) {
        if (cancelled.isEmpty()) {
            request.respond(481, "Call/Transaction Does Not Exist");
            return;
        }
        request.respond(200, "OK");
        users.values().stream()
                .flatMap(user -> user.call().stream())
                .filter(call -> call.isOf(cancelled.get()))
                .forEach(SipCall::cancelled);
    }

    private void outsideCall(ServerTransaction request) {
        switch (request.request().method()) {
            case "OPTIONS" ->
                request.send(request.response(200, "OK")
                        .with("Allow", METHODS)
                        .with("Accept", "application/sdp, application/dtmf-relay, " + TEXT));
            case "REGISTER" -> register(request);
            case "INVITE" -> callOf(request);
            case "MESSAGE" -> message(request);
            default -> request.respond(481, "Call/Transaction Does Not Exist");
        }
    }

    private void refuse(ServerTransaction request, int status, String text) {
        request.respond(status, text);
        listener.refused(request.peer().toString(), status, text);
    }

    /** True if the request has the password of the number; else it is answered. */
    private boolean isAuthorized(ServerTransaction request, String number) {
        long now = context.timers().nowNanos();
        String host = request.peer().host();
        if (guesses.isFull(host, now)) {
            refuse(request, 403, "Forbidden: too many wrong passwords, try again in a minute");
            return false;
        }
        SipMessage message = request.request();
        boolean isOther =
                SipDigest.user(message).filter(user -> !user.equals(number)).isPresent();
        String password = isOther ? "" : passwords.getOrDefault(number, "");
        SipDigest.DigestResult result = digest.check(message, password, now);
        if (result == SipDigest.DigestResult.WRONG) {
            guesses.count(host, now);
            String what = passwords.containsKey(number)
                    ? "wrong password of " + number
                    : number + " was no user at the start";
            listener.refused(request.peer().toString(), 401, what);
        }
        if (result != SipDigest.DigestResult.RIGHT) {
            SipMessage answer = request.response(401, "Unauthorized");
            digest.challenge(message, answer, result == SipDigest.DigestResult.STALE, now);
            request.send(answer);
        }
        return result == SipDigest.DigestResult.RIGHT;
    }

    /** The number is that of To, never of Contact: phones put other words there. */
    private void register(ServerTransaction request) {
        String number = request.request().address("To").user();
        if (!isAuthorized(request, number)) {
            return;
        }
        Optional<SipUser> known = user(number);
        List<String> contacts = request.request().values("Contact");
        if (contacts.isEmpty()) {
            known.ifPresentOrElse(user -> user.confirm(request), () -> request.respond(200, "OK"));
            return;
        }
        SipValue contact = SipValue.parse(contacts.get(0));
        boolean isAll = contact.main().equals("*");
        int seconds =
                seconds(contact.parameter("expires").or(() -> request.request().header("Expires")));
        if (isAll || seconds == 0) {
            known.filter(user -> isAll || user.isBoundTo(contact.main())).ifPresent(SipUser::unbind);
            known.ifPresentOrElse(user -> user.confirm(request), () -> request.respond(200, "OK"));
        } else if (seconds < LEAST_SECONDS) {
            request.send(request.response(423, "Interval Too Brief").with("Min-Expires", "" + LEAST_SECONDS));
        } else if (known.isEmpty() && users.containsKey(number)) {
            request.send(request.response(503, "Service Unavailable: the number is being detached")
                    .with("Retry-After", "2"));
        } else if (known.isEmpty() && users.size() >= MOST_USERS) {
            refuse(request, 503, "Service Unavailable: at most " + MOST_USERS + " SIP users");
        } else {
            users.computeIfAbsent(number, it -> new SipUser(context, this, new Msisdn(it)))
                    .register(request, contact.main(), seconds);
        }
    }

    /** One hour if it is missing or not a number (10.2.1.1, 20.19). */
    private static int seconds(Optional<String> given) {
        return given.map(String::strip)
                .filter(text -> text.matches("[0-9]{1,9}"))
                .map(text -> Math.min(MOST_SECONDS, Integer.parseInt(text)))
                .orElse(MOST_SECONDS);
    }

    /** The user of a request outside a call; empty if the request has been answered. */
    private Optional<SipUser> sender(ServerTransaction request) {
        String number = request.request().address("From").user();
        Optional<SipUser> user = user(number).filter(SipUser::isRegistered);
        if (user.isEmpty()) {
            refuse(request, 403, "Forbidden: " + (number.isEmpty() ? "the caller" : number) + " is not registered");
            return user;
        }
        return user.filter(it -> isAuthorized(request, number));
    }

    /** The number that a request is for; empty if the request has been answered. */
    private Optional<Msisdn> number(ServerTransaction request) {
        String text = SipValue.parse("<" + request.request().uri() + ">").user();
        try {
            return Optional.of(Msisdn.parse(text));
        } catch (IllegalArgumentException e) {
            request.respond(404, "Not Found: expected a number before @");
            return Optional.empty();
        }
    }

    private void callOf(ServerTransaction request) {
        sender(request).ifPresent(user -> number(request).ifPresent(to -> user.invited(request, to)));
    }

    private void message(ServerTransaction request) {
        String type = request.request().contentType();
        Optional<SipUser> from = sender(request);
        if (from.isEmpty()) {
            return;
        }
        if (REPORTS.contains(type)) {
            request.respond(200, "OK");
        } else if (!type.equals(TEXT)
                || request.request().header("Content-Encoding").isPresent()) {
            request.send(request.response(415, "Unsupported Media Type").with("Accept", TEXT));
        } else {
            number(request).ifPresent(to -> from.get().submit(request, to));
        }
    }
}

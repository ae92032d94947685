package simgsm.gateway;

import java.security.SecureRandom;
import java.util.Collection;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.station.StationThread;
import simgsm.station.context.StationIdentity;
import simgsm.web.AccessKeys;
import simgsm.web.RequestException;
import simgsm.web.WebResponse;
import simgsm.web.WebSocket;

/** The browsers that are subscribers: each has a number while its page is open, and for 60 s more. */
final class WebUsers {
    /** Maximum of browsers. */
    static final int MOST = 200;

    private static final long RETURN_NANOS = TimeUnit.SECONDS.toNanos(60);
    private static final long KEY_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final int MOST_NAME = 30;
    private static final int TOKEN_OCTETS = 16;
    private static final String UNIT_NAME = "SimGSM web phone";

    private final StationThread thread;
    private final GatewaySettings settings;
    private final Consumer<GatewayEvent> listener;
    private final AccessKeys keys;
    private final SecureRandom random = new SecureRandom();
    private final PageWords texts;
    private final Map<Long, WebUser> byNumber = new TreeMap<>();
    /** Offset of the number after the last assigned one. */
    private int given;

    private boolean isLocked;

    WebUsers(StationThread thread, GatewaySettings settings, Consumer<GatewayEvent> listener) {
        this.thread = thread;
        this.settings = settings;
        keys = AccessKeys.of("link", settings.key());
        this.listener = listener;
        texts = new PageWords(settings.language());
    }

    /** The link's key. */
    AccessKeys keys() {
        return keys;
    }

    /**
     * Admits a page with its key and its user's name.
     *
     * @return empty if it is refused: its socket closes
     */
    Optional<WebUser> join(WebSocket socket, String key, String token, String name) {
        try {
            keys.operator(key, socket.peer(), System.nanoTime());
        } catch (RequestException wrong) {
            boolean isKnownWrong = wrong.status() == WebResponse.UNAUTHORIZED;
            return refused(socket, isKnownWrong ? CloseCode.WRONG_KEY : CloseCode.TRY_AGAIN_LATER, wrong.getMessage());
        }
        Optional<WebUser> known = byNumber.values().stream()
                .filter(user -> user.token().equals(token) && !user.isLeaving())
                .findFirst();
        if (known.isEmpty() && isLocked) {
            return refused(socket, CloseCode.LOCKED, "locked");
        }
        Optional<WebUser> user = known.or(this::newUser);
        if (user.isEmpty()) {
            return refused(socket, CloseCode.NO_NUMBER, "no number free, at most " + most());
        }
        user.get().attach(socket, name.length() > MOST_NAME ? name.substring(0, MOST_NAME) : name);
        listener.accept(new GatewayEvent.Joined(user.get()));
        return user;
    }

    private int most() {
        return (int) Math.min(MOST, settings.lastNumber() - settings.firstNumber() + 1);
    }

    private Optional<WebUser> newUser() {
        // numbers returned first are assigned last, because messages to the last user may still arrive
        for (int i = 0; i < most(); i++) {
            int place = (given + i) % most();
            long number = settings.firstNumber() + place;
            if (!byNumber.containsKey(number)) {
                given = place + 1;
                byte[] token = new byte[TOKEN_OCTETS];
                random.nextBytes(token);
                StationIdentity identity =
                        StationIdentity.ofOpenNumber(new Msisdn(Long.toString(number)), Imei.random(random), UNIT_NAME);
                WebUser user = new WebUser(identity, HexFormat.of().formatHex(token), place, most(), texts);
                byNumber.put(number, user);
                thread.add(user.station(), settings.center());
                return Optional.of(user);
            }
        }
        return Optional.empty();
    }

    private Optional<WebUser> refused(WebSocket socket, int cause, String text) {
        socket.close(cause, text);
        listener.accept(new GatewayEvent.Refused(GatewayEvent.WEB, socket.peer().getHostAddress(), cause, text));
        return Optional.empty();
    }

    /** Closes a socket whose page has not sent its key in time. */
    void expectKey(WebSocket socket, BooleanSupplier isShown) {
        thread.after(KEY_NANOS, () -> {
            if (!isShown.getAsBoolean()) {
                socket.close(CloseCode.POLICY_VIOLATION, "expected the key within 10 s");
            }
        });
    }

    /** Handles the end of a page's socket; within 60 s its token restores the number. */
    void pageGone(WebUser user, WebSocket socket) {
        if (user.detach(socket)) {
            listener.accept(new GatewayEvent.Left(user));
            int absence = user.absences();
            thread.after(RETURN_NANOS, () -> {
                if (!user.hasPage() && user.absences() == absence) {
                    remove(user);
                }
            });
        }
    }

    private void remove(WebUser user) {
        user.leave();
        long number = Long.parseLong(user.number().digits());
        thread.remove(user.station(), () -> byNumber.remove(number, user));
    }

    /**
     * Ends a user at once.
     *
     * @return false if the number is unused
     */
    boolean drop(Msisdn number) {
        Optional<WebUser> user = byNumber.values().stream()
                .filter(each -> each.number().equals(number))
                .findFirst();
        user.ifPresent(dropped -> {
            dropped.end(CloseCode.DROPPED, "ended by the operator");
            remove(dropped);
        });
        return user.isPresent();
    }

    /** @param locked true to refuse browsers without a token */
    void setLocked(boolean locked) {
        isLocked = locked;
    }

    Collection<WebUser> all() {
        return byNumber.values();
    }
}

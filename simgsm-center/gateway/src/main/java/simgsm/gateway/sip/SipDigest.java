package simgsm.gateway.sip;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import simgsm.timer.BoundedMap;

/**
 * Digest authentication (RFC 7616, RFC 8760): MD5 and SHA-256 with {@code qop=auth}. Each challenge has a fresh nonce,
 * because baresip counts from 1 for each one; a nonce is valid for 5 min, and each of its counts once.
 */
final class SipDigest {
    static final String REALM = "simgsm";

    /** Results of {@link #check}. */
    enum DigestResult {
        RIGHT,
        WRONG,
        /** The password is right, the nonce is not fresh. */
        STALE,
        MISSING
    }

    private static final long NONCE_NANOS = TimeUnit.MINUTES.toNanos(5);
    private static final String MD5 = "MD5";
    private static final String PREFIX = "digest ";

    /** @param count the highest count received, in use of its client */
    private record Nonce(long madeNanos, long count) {}

    private final Map<String, Nonce> nonces = new BoundedMap<>();
    /** Requests without credentials, by Call-ID and tag of From: some phones count Call-IDs from each start. */
    private final Map<String, Integer> asked = new BoundedMap<>();

    private final Supplier<String> words;

    /** @param words gives a random word for each nonce */
    SipDigest(Supplier<String> words) {
        this.words = words;
    }

    /**
     * Adds a challenge to a 401, of one algorithm, because baresip 1.0 and others refuse a challenge beside SHA-256: that
     * of the request, else MD5, and SHA-256 for a client that comes again without credentials.
     */
    void challenge(SipMessage request, SipMessage response, boolean isStale, long nowNanos) {
        String algorithm = credentials(request).map(SipDigest::algorithm).orElseGet(() -> {
            boolean isAgain =
                    asked.merge(request.callId() + " " + request.address("From").tag(), 1, Integer::sum) % 2 == 0;
            return isAgain ? "SHA-256" : MD5;
        });
        String nonce = words.get() + words.get();
        nonces.put(nonce, new Nonce(nowNanos, 0));
        response.with(
                "WWW-Authenticate",
                "Digest realm=\"" + REALM + "\", nonce=\"" + nonce + "\", algorithm=" + algorithm + ", qop=\"auth\""
                        + (isStale ? ", stale=true" : ""));
    }

    private static String algorithm(Map<String, String> credentials) {
        return credentials.getOrDefault("algorithm", MD5).equalsIgnoreCase("SHA-256") ? "SHA-256" : MD5;
    }

    /** The user name that a request gives with its credentials; empty without credentials for this realm. */
    static Optional<String> user(SipMessage request) {
        return credentials(request).map(fields -> fields.getOrDefault("username", ""));
    }

    private static Optional<Map<String, String>> credentials(SipMessage request) {
        return request.fields("Authorization").stream()
                .filter(field -> field.toLowerCase(Locale.ROOT).startsWith(PREFIX))
                .map(field -> fields(field.substring(PREFIX.length())))
                .filter(fields -> REALM.equals(fields.get("realm")))
                .findFirst();
    }

    private static Map<String, String> fields(String text) {
        Map<String, String> fields = new HashMap<>();
        for (String part : SipValue.split(text, ',')) {
            int equals = part.indexOf('=');
            if (equals > 0) {
                fields.putIfAbsent(
                        part.substring(0, equals).strip().toLowerCase(Locale.ROOT),
                        SipValue.unquoted(part.substring(equals + 1).strip()));
            }
        }
        return fields;
    }

    /** Checks the credentials of a request, whose user has this password; an empty one is never right. */
    DigestResult check(SipMessage request, String password, long nowNanos) {
        Optional<Map<String, String>> given = credentials(request);
        if (given.isEmpty()) {
            return DigestResult.MISSING;
        }
        Map<String, String> fields = given.get();
        String algorithm = algorithm(fields);
        String qop = fields.getOrDefault("qop", "");
        if (password.isEmpty() || !qop.isEmpty() && !qop.equals("auth")) {
            return DigestResult.WRONG;
        }
        String nonce = fields.getOrDefault("nonce", "");
        String count = fields.getOrDefault("nc", "");
        String first = hash(algorithm, fields.getOrDefault("username", "") + ":" + REALM + ":" + password);
        String second = hash(algorithm, request.method() + ":" + fields.getOrDefault("uri", ""));
        String middle = qop.isEmpty() ? nonce : nonce + ":" + count + ":" + fields.get("cnonce") + ":" + qop;
        byte[] expected = hash(algorithm, first + ":" + middle + ":" + second).getBytes(StandardCharsets.US_ASCII);
        byte[] response =
                fields.getOrDefault("response", "").toLowerCase(Locale.ROOT).getBytes(StandardCharsets.US_ASCII);
        if (!MessageDigest.isEqual(expected, response)) {
            return DigestResult.WRONG;
        }
        asked.remove(request.callId());
        return isFresh(nonce, qop.isEmpty() ? "1" : count, nowNanos) ? DigestResult.RIGHT : DigestResult.STALE;
    }

    private boolean isFresh(String nonce, String count, long nowNanos) {
        Nonce known = nonces.get(nonce);
        long number = count.matches("[0-9a-fA-F]{1,8}") ? Long.parseLong(count, 16) : 0;
        if (known == null || nowNanos - known.madeNanos > NONCE_NANOS || number <= known.count) {
            return false;
        }
        nonces.put(nonce, new Nonce(known.madeNanos, number));
        return true;
    }

    private static String hash(String algorithm, String text) {
        try {
            byte[] octets = MessageDigest.getInstance(algorithm).digest(text.getBytes(StandardCharsets.UTF_8));
            return HexFormat.of().formatHex(octets);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("each Java platform has MD5 and SHA-256", e);
        }
    }
}

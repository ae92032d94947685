package simgsm.sim;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;

/** Reads the lines of a {@link SimFile}; anything else than its format is an error. */
final class SimFileReader {
    private static final String LINES = "sim ... or barred-imei IMEI";
    private static final String BYTE_ORDER_MARK = "\ufeff";
    private static final Set<String> FIELDS = Set.of(
            "number", "imsi", "k", "op", "opc", "algorithm", "pin", "puk", "pin-enabled", "pin-tries", "puk-tries");

    private final String file;
    private final List<Subscription> subscriptions = new ArrayList<>();
    private final Set<Imei> barredEquipment = new LinkedHashSet<>();
    /** Numbers and IMSIs, each with its line. */
    private final Map<Object, Integer> seen = new HashMap<>();

    private int line;

    SimFileReader(String file) {
        this.file = file;
    }

    SimFile read(List<String> lines) throws IOException {
        for (String text : lines) {
            line++;
            try {
                readLine(line == 1 && text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text);
            } catch (IllegalArgumentException e) {
                throw new IOException(file + ", line " + line + ": " + e.getMessage(), e);
            }
        }
        return new SimFile(subscriptions, barredEquipment);
    }

    private void readLine(String text) {
        int comment = text.indexOf('#');
        String content = (comment < 0 ? text : text.substring(0, comment)).strip();
        if (content.isEmpty()) {
            return;
        }
        List<String> words = List.of(content.split("\\s+"));
        switch (words.get(0)) {
            case "sim" -> readSim(words.subList(1, words.size()));
            case "barred-imei" -> readBarredImei(words.subList(1, words.size()));
            default -> throw new IllegalArgumentException("expected " + LINES + ", found " + words.get(0));
        }
    }

    private void readBarredImei(List<String> words) {
        if (words.size() != 1) {
            throw new IllegalArgumentException("expected one IMEI after barred-imei, found " + words.size() + " words");
        }
        barredEquipment.add(new Imei(words.get(0)));
    }

    private void readSim(List<String> words) {
        if (subscriptions.size() == SimFile.MAX_SUBSCRIPTIONS) {
            throw new IllegalArgumentException("more than " + SimFile.MAX_SUBSCRIPTIONS + " SIMs");
        }
        Map<String, String> fields = new LinkedHashMap<>();
        boolean isBarred = false;
        for (String word : words) {
            if (word.equals("barred")) {
                isBarred = true;
            } else {
                addField(fields, word);
            }
        }
        SimCard card = card(fields);
        requireNew("number", card.number());
        requireNew("IMSI", card.imsi());
        subscriptions.add(new Subscription(card, isBarred));
    }

    /** The error does not contain the value, because it may be a key. */
    private static void addField(Map<String, String> fields, String word) {
        int equals = word.indexOf('=');
        String name = equals < 0 ? word : word.substring(0, equals);
        if (equals < 0 || !FIELDS.contains(name)) {
            throw new IllegalArgumentException(
                    "expected number=, imsi=, k=, opc= (or op=), algorithm=, pin=, puk=, pin-enabled= or barred, found "
                            + name + (equals < 0 ? "" : "="));
        }
        if (fields.put(name, word.substring(equals + 1)) != null) {
            throw new IllegalArgumentException("expected " + name + "= once, found it twice");
        }
    }

    private static SimCard card(Map<String, String> fields) {
        Msisdn number = new Msisdn(required(fields, "number"));
        Imsi imsi = new Imsi(required(fields, "imsi"));
        OctetString k = key(fields, "k");
        CardAlgorithm algorithm = CardAlgorithm.named(fields.getOrDefault("algorithm", CardAlgorithm.MILENAGE.word()));
        return new SimCard(imsi, number, k, algorithm, opc(fields, k, algorithm), pin(fields));
    }

    private static Optional<OctetString> opc(Map<String, String> fields, OctetString k, CardAlgorithm algorithm) {
        boolean hasOp = fields.containsKey("op");
        if (algorithm != CardAlgorithm.MILENAGE) {
            if (hasOp || fields.containsKey("opc")) {
                throw new IllegalArgumentException("expected neither opc= nor op= with " + algorithm.word());
            }
            return Optional.empty();
        }
        if (hasOp == fields.containsKey("opc")) {
            throw new IllegalArgumentException("expected opc= or op=, found " + (hasOp ? "both" : "neither"));
        }
        return Optional.of(hasOp ? Milenage.opc(k, key(fields, "op")) : key(fields, "opc"));
    }

    private static Optional<CardPin> pin(Map<String, String> fields) {
        if (!fields.containsKey("pin")) {
            if (fields.keySet().stream().anyMatch(name -> name.startsWith("pin-") || name.startsWith("puk"))) {
                throw new IllegalArgumentException("expected pin=, found none");
            }
            return Optional.empty();
        }
        String enabled = fields.getOrDefault("pin-enabled", "true");
        if (!enabled.equals("true") && !enabled.equals("false")) {
            throw new IllegalArgumentException("expected pin-enabled= with true or false, found " + enabled);
        }
        return Optional.of(new CardPin(
                fields.get("pin"),
                required(fields, "puk"),
                enabled.equals("true"),
                tries(fields, "pin-tries", CardPin.TRIES),
                tries(fields, "puk-tries", CardPin.PUK_TRIES)));
    }

    private static int tries(Map<String, String> fields, String name, int most) {
        String text = fields.getOrDefault(name, String.valueOf(most));
        if (!text.matches("[0-9]{1,2}")) {
            throw new IllegalArgumentException("expected " + name + "= with 0 to " + most + ", found " + text);
        }
        return Integer.parseInt(text);
    }

    private static String required(Map<String, String> fields, String name) {
        String value = fields.get(name);
        if (value == null) {
            throw new IllegalArgumentException("expected " + name + "=, found none");
        }
        return value;
    }

    private static OctetString key(Map<String, String> fields, String name) {
        String value = required(fields, name);
        if (!value.matches("[0-9a-fA-F]{" + 2 * Milenage.KEY_LENGTH + "}")) {
            throw new IllegalArgumentException("expected " + name + "= with " + 2 * Milenage.KEY_LENGTH
                    + " hexadecimal digits, found " + value.length() + " characters"
                    + (value.length() == 2 * Milenage.KEY_LENGTH ? ", not all of them hexadecimal digits" : ""));
        }
        return OctetString.ofHex(value);
    }

    private void requireNew(String what, Object value) {
        Integer before = seen.put(value, line);
        if (before != null) {
            throw new IllegalArgumentException(
                    "expected each " + what + " once, found " + value + ", which line " + before + " has already");
        }
    }
}

package simgsm.center.smpp;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.Map;

/** Applications that may bind. */
public final class SmppUsers {
    private static final int MAX_SYSTEM_ID = 15;
    private static final int MAX_PASSWORD = 8;

    private final Map<String, String> passwords;
    private final boolean isOpen;

    private SmppUsers(Map<String, String> passwords, boolean isOpen) {
        this.passwords = Map.copyOf(passwords);
        this.isOpen = isOpen;
    }

    /** Any application on this machine, none on another. */
    public static SmppUsers anyLocal() {
        return new SmppUsers(Map.of(), true);
    }

    /**
     * Only the listed applications.
     *
     * @param passwords by system id
     * @throws IllegalArgumentException for an id of over 15 or a password of over 8 characters (5.2.1, 5.2.2)
     */
    public static SmppUsers only(Map<String, String> passwords) {
        passwords.forEach((id, password) -> {
            if (id.isEmpty() || id.length() > MAX_SYSTEM_ID) {
                throw new IllegalArgumentException("system id \"" + id + "\" is not of 1 to 15 characters");
            }
            if (password.length() > MAX_PASSWORD) {
                throw new IllegalArgumentException("the password of " + id + " is longer than 8 characters");
            }
        });
        return new SmppUsers(passwords, false);
    }

    /** The command_status of a bind. */
    int check(String systemId, String password, boolean isLocal) {
        if (systemId.isEmpty()) {
            return SmppStatus.INVALID_SYSTEM_ID;
        }
        if (isOpen) {
            return isLocal ? SmppStatus.OK : SmppStatus.BIND_FAILED;
        }
        String expected = passwords.get(systemId);
        if (expected == null) {
            return SmppStatus.INVALID_SYSTEM_ID;
        }
        boolean isRight = MessageDigest.isEqual(octets(expected), octets(password));
        return isRight ? SmppStatus.OK : SmppStatus.INVALID_PASSWORD;
    }

    private static byte[] octets(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }
}

package simgsm.center.smpp;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import simgsm.smpp.SmppStatus;

/** Applications that may bind, with their settings. */
public final class SmppUsers {
    private static final int MAX_SYSTEM_ID = 15;
    private static final int MAX_PASSWORD = 8;

    private record User(String password, EsmeSettings settings) {}

    private final Map<String, User> users;
    private final NumberOwners owners;
    private final boolean isOpen;

    private SmppUsers(Map<String, User> users, NumberOwners owners, boolean isOpen) {
        this.users = Map.copyOf(users);
        this.owners = owners;
        this.isOpen = isOpen;
    }

    /** Any application on this machine, none on another. */
    public static SmppUsers anyLocal() {
        return new SmppUsers(Map.of(), new NumberOwners(), true);
    }

    /**
     * Only the listed applications.
     *
     * @param lines {@code id=password}, and {@code id.SETTING=value} for its settings
     * @throws IllegalArgumentException naming the wrong line, such as an id of over 15 characters or a password of over
     * 8 (5.2.1, 5.2.2)
     */
    public static SmppUsers only(Map<String, String> lines) {
        Map<String, User> users = new HashMap<>();
        NumberOwners owners = new NumberOwners();
        // sorted, so that an id precedes its settings
        new TreeMap<>(lines).forEach((key, value) -> {
            int dot = settingAfter(key, users);
            if (dot < 0) {
                users.put(key, user(key, value));
            } else {
                String id = key.substring(0, dot);
                users.put(id, changed(users.get(id), owners, id, key.substring(dot + 1), value));
            }
        });
        return new SmppUsers(users, owners, false);
    }

    /**
     * The dot between a system id and the name of a setting; -1 if the key is a system id, which may also have dots.
     */
    private static int settingAfter(String key, Map<String, User> users) {
        for (int dot = key.indexOf('.'); dot >= 0; dot = key.indexOf('.', dot + 1)) {
            String id = key.substring(0, dot);
            boolean isSetting = EsmeSettings.isSetting(key.substring(dot + 1));
            if (isSetting && !users.containsKey(id)) {
                throw new IllegalArgumentException(key + ": there is no line " + id + "=password");
            }
            if (isSetting || users.containsKey(id)) {
                return dot;
            }
        }
        return -1;
    }

    private static User user(String id, String password) {
        if (id.isEmpty() || id.length() > MAX_SYSTEM_ID) {
            throw new IllegalArgumentException("system id \"" + id + "\" is not of 1 to 15 characters");
        }
        if (password.length() > MAX_PASSWORD) {
            throw new IllegalArgumentException("the password of " + id + " is longer than 8 characters");
        }
        return new User(password, EsmeSettings.STANDARD);
    }

    private static User changed(User user, NumberOwners owners, String id, String name, String value) {
        String key = id + "." + name;
        if (!EsmeSettings.isSetting(name)) {
            throw new IllegalArgumentException(
                    key + ": expected numbers, alphabet, window, rate or retry.0xSTATUS, found " + name);
        }
        try {
            if (name.equals(EsmeSettings.NUMBERS)) {
                owners.add(id, value);
                return user;
            }
            return new User(user.password, user.settings.with(name, value.strip()));
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(key + ": " + e.getMessage());
        }
    }

    /** The command_status of a bind. */
    int check(String systemId, String password, boolean isLocal) {
        if (systemId.isEmpty()) {
            return SmppStatus.INVALID_SYSTEM_ID;
        }
        if (isOpen) {
            return isLocal ? SmppStatus.OK : SmppStatus.BIND_FAILED;
        }
        User user = users.get(systemId);
        if (user == null) {
            return SmppStatus.INVALID_SYSTEM_ID;
        }
        boolean isRight = MessageDigest.isEqual(octets(user.password), octets(password));
        return isRight ? SmppStatus.OK : SmppStatus.INVALID_PASSWORD;
    }

    private static byte[] octets(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    /** The owners of numbers. */
    NumberOwners owners() {
        return owners;
    }

    EsmeSettings settings(String systemId) {
        User user = users.get(systemId);
        return user == null ? EsmeSettings.STANDARD : user.settings;
    }
}

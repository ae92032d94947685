package simgsm.phone.ui;

import java.util.ArrayList;
import java.util.List;

/**
 * Keys of a call grouped like orders, {@code ** #**20 **   ** #*#90 **}: a gap after each part of an order and a
 * wider one between orders. Nothing is checked; keys outside orders are one group.
 */
final class KeyGroups {
    private static final String MARK = "**";
    private static final String STOP = "###";

    /** A part of an order. @param begins true for the first of its order */
    record Group(String keys, boolean begins) {}

    private final String keys;
    private final List<Group> groups = new ArrayList<>();
    private final StringBuilder part = new StringBuilder();
    private boolean isOpen;
    private boolean beginsNext = true;

    private KeyGroups(String keys) {
        this.keys = keys;
    }

    static List<Group> of(String keys) {
        KeyGroups reader = new KeyGroups(keys);
        reader.read();
        return reader.groups;
    }

    private void read() {
        int at = 0;
        while (at < keys.length()) {
            boolean afterHash = part.length() > 0 && part.charAt(part.length() - 1) == '#' && !isStop();
            if (keys.startsWith(MARK, at) && !afterHash) {
                at = isOpen ? close(at) : open(at);
            } else {
                add(keys.charAt(at++));
            }
        }
        endPart();
    }

    /** Further stars belong to the opening. */
    private int open(int from) {
        endPart();
        int end = from;
        while (end < keys.length() && keys.charAt(end) == '*') {
            end++;
        }
        beginsNext = true;
        end(keys.substring(from, end));
        isOpen = true;
        return end;
    }

    private int close(int from) {
        endPart();
        end(MARK);
        isOpen = false;
        beginsNext = true;
        return from + MARK.length();
    }

    /** In an order a hash begins the next instruction if the one before can end. */
    private void add(char key) {
        boolean canEnd = isStop() || part.length() > 0 && Character.isDigit(part.charAt(part.length() - 1));
        if (isOpen && key == '#' && canEnd) {
            endPart();
        }
        part.append(key);
    }

    private boolean isStop() {
        return part.toString().equals(STOP);
    }

    private void endPart() {
        if (part.length() > 0) {
            end(part.toString());
            part.setLength(0);
        }
    }

    private void end(String group) {
        groups.add(new Group(group, beginsNext));
        beginsNext = false;
    }
}

package simgsm.phone.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.StringJoiner;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.phone.ui.KeyGroups.Group;

/** Keys of a call in the groups in which one reads them. */
class KeyGroupsTest {
    /** Parts by a blank, orders by a bar. */
    private static String shown(String keys) {
        StringJoiner orders = new StringJoiner("|");
        StringBuilder order = new StringBuilder();
        for (Group group : KeyGroups.of(keys)) {
            if (group.begins() && order.length() > 0) {
                orders.add(order);
                order.setLength(0);
            }
            order.append(order.length() > 0 ? " " : "").append(group.keys());
        }
        return orders.add(order).toString();
    }

    @ParameterizedTest
    @CsvSource({
        "5550200, 5550200",
        "*, *",
        "**, **",
        "**#**20, ** #**20",
        "**#**20**, ** #**20 **",
        "**20****#*#90**, ** 20 **|** #*#90 **",
        "**#**20****#*#90**, ** #**20 **|** #*#90 **",
        "***#**20**, *** #**20 **",
        "**#**100#*#90#**100**, ** #**100 #*#90 #**100 **",
        "**###**, ** ### **",
        "**###****#*0**, ** ### **|** #*0 **",
        "**####*0**, ** ### #*0 **",
        "**#*0**, ** #*0 **",
        "12**#*1**3, 12|** #*1 **|3",
        "**#**20**#, ** #**20 **|#",
    })
    void ordersAndTheirPartsAreApart(String keys, String groups) {
        assertEquals(groups, shown(keys));
    }
}

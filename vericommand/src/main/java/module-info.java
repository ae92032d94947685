/**
 * The command language of the paper, the robot's status, the verdict on an order and the reply tones. Needs nothing but
 * the JDK's base.
 */
module vericommand {
    exports vericommand;
}

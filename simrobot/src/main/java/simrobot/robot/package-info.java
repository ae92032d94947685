/**
 * The Pioneer 2-DX: what it is ({@link simrobot.robot.Pioneer2Dx}), how it drives ({@link simrobot.robot.Trapezoid}),
 * how it is driven directly ({@link simrobot.robot.Drive}),
 * what its sonars hear ({@link simrobot.robot.SonarRing}), and the robot itself
 * ({@link simrobot.robot.SimulatedRobot}, read it first). Arrows: robot -&gt; world, robot -&gt; vericommand.
 */
package simrobot.robot;
